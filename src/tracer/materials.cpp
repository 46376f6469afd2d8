#include "tracer/materials.h"

#include "scene/scene.h"
#include "tracer/sampling.h"
#include "tracer/sharp_targets.h"

namespace orbs::tracer {

namespace {

// Adds what a model needs to the world, and says where.
struct Preparation {
  const scene::Scene& scene;
  World& world;

  Colour colour(const scene::RgbColour& rgb, const std::optional<scene::SpectrumUse>& spectrum) const {
    return {cast<float>(rgb), add_spectrum(scene, spectrum, world)};
  }

  SurfaceMaterial operator()(const scene::Lambert& m) const {
    return {.model = Model::Lambert, .colour = colour(m.reflectance, m.spectrum)};
  }
  SurfaceMaterial operator()(const scene::OrenNayar& m) const {
    return {.model = Model::OrenNayar,
            .colour = colour(m.reflectance, m.spectrum),
            .roughness = static_cast<float>(m.roughness)};
  }
  SurfaceMaterial operator()(const scene::Mirror& m) const {
    return {.model = Model::Mirror, .colour = colour(m.reflectance, m.spectrum)};
  }
  SurfaceMaterial operator()(const scene::Glass& m) const {
    return {.model = Model::Glass, .colour = colour(m.colour, {}), .ior = static_cast<float>(m.ior)};
  }
  SurfaceMaterial operator()(const scene::Ggx& m) const {
    return {
        .model = Model::Ggx, .colour = colour(m.colour, m.spectrum), .alpha = static_cast<float>(m.alpha)};
  }
  SurfaceMaterial operator()(const scene::RoughGlass& m) const {
    return {.model = Model::RoughGlass,
            .colour = colour(m.colour, {}),
            .alpha = static_cast<float>(m.alpha),
            .ior = static_cast<float>(m.ior)};
  }
  SurfaceMaterial operator()(const scene::Emission& m) const {
    return {.model = Model::Emission, .colour = colour(m.radiance, m.spectrum)};
  }
  SurfaceMaterial operator()(const scene::Conductor& m) const {
    world.conductors.push_back(m);
    return {.model = Model::Conductor,
            .alpha = alpha_of(m.roughness),
            .details = static_cast<int>(world.conductors.size()) - 1};
  }
  SurfaceMaterial operator()(const scene::Dielectric& m) const {
    world.dielectrics.push_back({m, scene::is_dispersive(m)});
    return {.model = Model::Dielectric,
            .alpha = alpha_of(m.roughness),
            .details = static_cast<int>(world.dielectrics.size()) - 1};
  }
  SurfaceMaterial operator()(const scene::Polariser& m) const {
    return sheet(snippets::polariser_along_x<float>(), m.axis);
  }
  SurfaceMaterial operator()(const scene::Retarder& m) const {
    constexpr double kRadians = std::numbers::pi / 180;
    return sheet(snippets::retarder_fast_along_x(static_cast<float>(m.retardance_deg * kRadians)), m.axis);
  }
  SurfaceMaterial operator()(const scene::Fluorescent& m) const {
    world.reradiations.push_back(m.reradiation);
    return {.model = Model::Fluorescent,
            .colour = colour(m.reflectance, m.spectrum),
            .details = static_cast<int>(world.reradiations.size()) - 1};
  }

 private:
  static float alpha_of(const std::optional<scene::Roughness>& roughness) {
    return roughness ? static_cast<float>(roughness->alpha) : 0;
  }
  SurfaceMaterial sheet(const snippets::AlignedMueller<float>& element, Vec3d axis) const {
    world.sheets.push_back({element, cast<float>(normalised(axis))});
    return {.model = Model::Sheet, .details = static_cast<int>(world.sheets.size()) - 1};
  }
};

}  // namespace

void add_materials(const scene::Scene& scene, World& world) {
  const Preparation prepare{scene, world};
  for (const auto& material : scene.materials) {
    SurfaceMaterial out = std::visit(prepare, material.model);
    if (const auto& use = scene::texture_of(material.model)) {
      out.texture = use->texture;
      out.uv = uv_map(use->matrix);
    }
    out.is_sharp = is_sharp(out);
    world.materials.push_back(out);
  }
  for (const int index : scene::visible_materials(scene))
    world.has_interfaces =
        world.has_interfaces || world.materials[static_cast<std::size_t>(index)].model >= Model::Conductor;
}

int add_spectrum(const scene::Scene& scene, const std::optional<scene::SpectrumUse>& use, World& world) {
  if (!use || world.transport == scene::LightTransport::Rgb) return -1;
  world.spectra.push_back(
      spectra::scaled(scene.spectra[static_cast<std::size_t>(use->spectrum)].spectrum, use->scale));
  return static_cast<int>(world.spectra.size()) - 1;
}

bool is_smooth(const SurfaceMaterial& material) {
  switch (material.model) {
    case Model::Mirror:
    case Model::Glass:
    case Model::Sheet:
      return true;
    case Model::Conductor:
    case Model::Dielectric:
      return material.alpha == 0;
    default:
      return false;
  }
}

}  // namespace orbs::tracer
