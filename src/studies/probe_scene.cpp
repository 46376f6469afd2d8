#include "studies/probe_scene.h"

#include "image/image_io.h"
#include "scene/lower_effects.h"
#include "scene/lower_geometry.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

// Points of the R3 sequence (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018):
// any number of them keeps about the largest distance there can be. g solves g^4 = g + 1. From 0.1 on, so
// that nothing is as black as what is not there.
Vec3d colour_of_thing(std::size_t index) {
  constexpr double kG = 1.2207440846057596;
  const auto spread = [&](double alpha) {
    const double at = 0.5 + alpha * static_cast<double>(index + 1);
    return 0.1 + 0.9 * (at - std::floor(at));
  };
  return {spread(1 / kG), spread(1 / (kG * kG)), spread(1 / (kG * kG * kG))};
}

std::string or_number(const std::string& name, std::size_t index) {
  return name.empty() ? fmt::format("{}", index) : fmt::format("'{}'", name);
}

void fit_camera(scene::Camera& camera, int most_px) {
  const int longer = std::max(camera.width_px, camera.height_px);
  if (longer <= most_px) return;
  const auto fitted = [&](int side) {
    return std::max(1, static_cast<int>(std::lround(static_cast<double>(side) * most_px / longer)));
  };
  camera.width_px = fitted(camera.width_px);
  camera.height_px = fitted(camera.height_px);
}

// Material number of a mesh in the scene -> its number in the probe.
using Renumbering = std::map<int, int>;

class Colouring {
 public:
  Colouring(const scene::Scene& from, ProbeScene& to) : from_(from), to_(to) {}

  /// The first instance of a mesh gives it its materials, each further one has a remap list from these.
  void instance(std::size_t index) {
    const auto& source = from_.instances[index];
    auto& mesh = to_.scene.meshes[static_cast<std::size_t>(source.mesh)];
    const auto& shown = from_.meshes[static_cast<std::size_t>(source.mesh)].triangle_materials;
    Renumbering things;
    for (const int material : shown)
      if (!things.contains(material)) things[material] = new_thing(name_of(index, material));
    auto& remap = to_.scene.instances[index].remap;
    remap.clear();
    const auto [first, is_first] = of_mesh_.try_emplace(source.mesh, things);
    if (is_first) {
      for (int& material : mesh.triangle_materials) material = things[material];
    } else {
      for (const auto& [material, thing] : things) remap.emplace_back(first->second[material], thing);
    }
  }

  /// A mesh that is never instanced: its colour in an image would be a fault.
  void unseen_mesh(std::size_t index) {
    auto& mesh = to_.scene.meshes[index];
    if (of_mesh_.contains(static_cast<int>(index))) return;
    const int thing = new_thing(fmt::format("mesh {}, which no instance shows", or_number(mesh.name, index)));
    mesh.triangle_materials.assign(mesh.triangles.size(), thing);
  }

  int new_thing(const std::string& name) {
    to_.things.push_back({name, colour_of_thing(to_.things.size())});
    return static_cast<int>(to_.things.size()) - 1;
  }

 private:
  std::string name_of(std::size_t index, int material) const {
    const auto& instance = from_.instances[index];
    const auto shown = static_cast<std::size_t>(scene::remapped(instance, material));
    return fmt::format("instance {}, material {}", or_number(instance.name, index),
                       or_number(from_.materials[shown].name, shown));
  }

  const scene::Scene& from_;
  ProbeScene& to_;
  std::map<int, Renumbering> of_mesh_;  // by its first instance
};

}  // namespace

ProbeScene coloured_by_thing(const scene::Scene& original, int most_px) {
  scene::Scene scene = original;
  scene::tessellate_spheres(scene);
  scene::drop_spectra(scene);
  scene.outputs = {};
  for (auto& light : scene.lights) light.reflectance = {};
  ProbeScene probe{scene, {}};
  auto& out = probe.scene;
  fit_camera(out.camera, most_px);
  out.environment = {};
  out.trace_depth = 1;
  out.textures.clear();
  out.materials.clear();
  Colouring colouring(scene, probe);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) colouring.instance(i);
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) colouring.unseen_mesh(i);
  for (const auto& thing : probe.things)
    out.materials.push_back(
        {fmt::format("thing {}", out.materials.size()), scene::Emission{thing.radiance, {}}});
  for (std::size_t i = 0; i < out.lights.size(); ++i) {
    const int thing = colouring.new_thing(fmt::format("light {}", or_number(out.lights[i].name, i)));
    out.lights[i].radiance = probe.things[static_cast<std::size_t>(thing)].radiance;
    out.lights[i].ies.reset();
  }
  return probe;
}

void write_ramp(const std::filesystem::path& file) {
  auto image = image::make_image(kRampSize, kRampSize, {"R", "G", "B"});
  for (int y = 0; y < kRampSize; ++y)
    for (int x = 0; x < kRampSize; ++x) {
      image.at(x, y, 0) = (static_cast<float>(x) + 0.5F) / kRampSize;
      image.at(x, y, 1) = 1 - (static_cast<float>(y) + 0.5F) / kRampSize;
      image.at(x, y, 2) = 1;
    }
  image::write_exr(image, file);
}

scene::Scene coloured_by_coordinates(const ProbeScene& probe, const std::filesystem::path& ramp) {
  scene::Scene out = probe.scene;
  out.textures = {{"ramp", ramp}};
  for (auto& material : out.materials) material.model = scene::Emission{{1, 1, 1}, scene::TextureUse{0, {}}};
  for (auto& light : out.lights) light.radiance = {};
  return out;
}

}  // namespace orbs::studies
