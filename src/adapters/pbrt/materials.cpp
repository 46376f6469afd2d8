#include "adapters/pbrt/materials.h"

#include "adapters/parts.h"
#include "adapters/pbrt/directives.h"
#include "adapters/tinted_image.h"
#include "scene/effects.h"

namespace orbs::adapters::pbrt {

namespace {

std::string named(const std::string& name, const std::string& type, const std::string& parameters) {
  return fmt::format("MakeNamedMaterial \"{}\" \"string type\" \"{}\" {}\n", name, type, parameters);
}

struct MaterialWriter {
  const Colours& colours;
  const std::string& name;
  const std::string& image;

  // pbrt's v runs up from the bottom row, as ours.
  std::string diffuse(scene::RgbColour reflectance,
                      const std::optional<scene::SpectrumUse>& spectrum,
                      const std::optional<scene::TextureUse>& use) const {
    if (!use) return named(name, "diffuse", colours.surface("reflectance", reflectance, spectrum));
    const scene::Texture& texture = colours.scene.textures[static_cast<std::size_t>(use->texture)];
    return fmt::format(
               "Texture \"{}-image\" \"spectrum\" \"imagemap\" \"string filename\" \"{}\" \"string "
               "filter\" \"bilinear\" \"string wrap\" \"{}\"\n",
               name, image, texture.wrap_u == scene::Wrap::Clamp ? "clamp" : "repeat") +
           named(name, "diffuse", fmt::format("\"texture reflectance\" \"{}-image\"", name));
  }
  // A conductor's reflectance grows towards grazing angles, ORB.S's mirrors have one for all. So a share of
  // the hits meets a full mirror and the rest meets black, which is right on average for a grey colour. pbrt
  // takes a reflectance of 1 for 0.9999 (k = 200 with eta 1); over all angles, weighed by the cosine, it then
  // lacks 16 / (3 k^2) = 1.3e-4.
  std::string share_of_full(double share, const std::string& roughness) const {
    return named(name + "-none", "diffuse", rgb("reflectance", {})) +
           named(name + "-full", "conductor", rgb("reflectance", {1, 1, 1}) + roughness) +
           named(name, "mix",
                 fmt::format("\"string materials\" [\"{0}-none\" \"{0}-full\"] \"float amount\" {1}", name,
                             share));
  }
  // Without remapping, pbrt's roughness is alpha.
  static std::string ggx(double alpha) {
    return fmt::format(" \"float roughness\" {} \"bool remaproughness\" false", alpha);
  }

  std::string operator()(const scene::Lambert& m) const {
    return diffuse(m.reflectance, m.spectrum, m.texture);
  }
  // pbrt_limits lets it through with roughness 0 only, and there it is Lambert's law.
  std::string operator()(const scene::OrenNayar& m) const {
    return diffuse(m.reflectance, m.spectrum, m.texture);
  }
  std::string operator()(const scene::Emission&) const { return diffuse({}, {}, {}); }
  std::string operator()(const scene::Mirror& m) const {
    return share_of_full(m.reflectance.x, " \"float roughness\" 0");
  }
  std::string operator()(const scene::Ggx& m) const { return share_of_full(m.colour.x, ggx(m.alpha)); }
  std::string operator()(const scene::Glass& m) const {
    return named(name, "dielectric", fmt::format("\"float eta\" {} \"float roughness\" 0", m.ior));
  }
  std::string operator()(const scene::RoughGlass& m) const {
    return named(name, "dielectric", fmt::format("\"float eta\" {}{}", m.ior, ggx(m.alpha)));
  }
  // pbrt has no index for what is outside of a conductor.
  std::string operator()(const scene::Conductor& m) const {
    return named(name, "conductor",
                 fmt::format("{} {}{}", spectrum("eta", samples_of_n(m)), spectrum("k", samples_of_k(m)),
                             m.roughness ? ggx(m.roughness->alpha) : " \"float roughness\" 0"));
  }
  // A spectrum makes pbrt go on with one wavelength alone from there, which a number does not.
  std::string operator()(const scene::Dielectric& m) const {
    const Samples eta = samples_of_ratio(m.index, m.outside);
    return named(name, "dielectric",
                 (is_dispersive(m) ? spectrum("eta", eta) : fmt::format("\"float eta\" {}", eta.front())) +
                     (m.roughness ? ggx(m.roughness->alpha) : " \"float roughness\" 0"));
  }
  // pbrt_limits lets none through that anything shows.
  std::string operator()(const scene::Polariser&) const { return diffuse({}, {}, {}); }
  std::string operator()(const scene::Retarder&) const { return diffuse({}, {}, {}); }
  std::string operator()(const scene::Fluorescent&) const { return diffuse({}, {}, {}); }
};

}  // namespace

std::string material_text(const Colours& colours, int material, const std::string& stem) {
  const auto& m = colours.scene.materials[static_cast<std::size_t>(material)];
  const std::string name = fmt::format("material{}", material);
  return fmt::format("# material {}\n", one_line(m.name)) +
         std::visit(MaterialWriter{colours, name, tinted_image_name(material, stem)}, m.model);
}

}  // namespace orbs::adapters::pbrt
