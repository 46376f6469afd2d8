#include "studies/probe/scene.h"

#include "base/error.h"
#include "base/nth.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "scene/camera_frame.h"
#include "scene/lower/geometry.h"
#include "scene/lower/lower.h"
#include "scene/motion.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

// Points of the R3 sequence (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018):
// any number of them keeps about the largest possible distance. g solves g^4 = g + 1. Values start at 0.1, so
// that no object is as black as the background.
Vec3d id_colour(std::size_t index) {
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

// Material index of a mesh in the scene -> index of its object in the probe.
using Renumbering = std::map<int, int>;

class IdPassBuilder {
 public:
  IdPassBuilder(const scene::Scene& from, ProbeScene& to) : from_(from), to_(to) {}

  /// The first instance of a mesh sets the mesh's materials; each further one gets a remap list.
  void instance(std::size_t index) {
    const auto& source = from_.instances[index];
    auto& mesh = nth(to_.scene.meshes, source.mesh);
    const auto& shown = nth(from_.meshes, source.mesh).triangle_materials;
    Renumbering objects;
    for (const int material : shown)
      if (!objects.contains(material)) objects[material] = new_object(name_of(index, material));
    auto& remap = to_.scene.instances[index].remap;
    remap.clear();
    const auto [first, is_first] = of_mesh_.try_emplace(source.mesh, objects);
    if (is_first) {
      for (int& material : mesh.triangle_materials) material = objects[material];
    } else {
      for (const auto& [material, object] : objects) remap.emplace_back(first->second[material], object);
    }
  }

  /// A mesh without instances gets an id too: seeing its colour in an image is a fault.
  void unseen_mesh(std::size_t index) {
    auto& mesh = to_.scene.meshes[index];
    if (of_mesh_.contains(static_cast<int>(index))) return;
    const int object =
        new_object(fmt::format("mesh {}, which no instance shows", or_number(mesh.name, index)));
    mesh.triangle_materials.assign(mesh.triangles.size(), object);
  }

  int new_object(const std::string& name) {
    to_.objects.push_back({name, id_colour(to_.objects.size())});
    return static_cast<int>(to_.objects.size()) - 1;
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

void fit_camera(scene::Camera& camera, int most_px) {
  const int longer = std::max(camera.width_px, camera.height_px);
  if (longer <= most_px) return;
  const auto fitted = [&](int side) {
    return std::max(1, static_cast<int>(std::lround(static_cast<double>(side) * most_px / longer)));
  };
  camera.width_px = fitted(camera.width_px);
  camera.height_px = fitted(camera.height_px);
}

ProbeScene make_id_pass(const scene::Scene& original, int most_px) {
  scene::Scene scene = scene::at_time(original, original.camera.shutter.open);
  scene::tessellate_spheres(scene);
  for (const char* level : {"S1", "S2"}) scene::tessellate_shapes(scene, level);
  if (!scene.shapes.empty())
    throw InputError(
        fmt::format("scene '{}': {} is {}, of which there are no triangles to number; take a scene "
                    "without S3 and S4",
                    scene.name, scene::display_name("shape", scene.shapes.front().name, 0),
                    what_is(scene.shapes.front().form)));
  if (!scene::is_perspective(scene.camera))
    throw InputError(fmt::format(
        "scene '{}': the camera is {}, and the probe follows the rays of perspectives; take a scene "
        "without C2 and C4",
        scene.name, std::visit([](const auto& kind) { return kind.kWhat; }, scene.camera.projection)));
  scene.camera.aperture_radius_m = 0;  // blurred numbers would be none: a lens is probed through its middle
  scene::drop_spectra(scene);
  scene.outputs = {};
  for (auto& light : scene.lights) light.reflectance = {};
  std::erase_if(scene.lights, [](const auto& light) { return !has_area(light.shape); });  // nobody sees them
  ProbeScene probe{scene, {}};
  auto& out = probe.scene;
  fit_camera(out.camera, most_px);
  out.environment = {};
  out.trace_depth = 1;
  out.textures.clear();
  out.materials.clear();
  IdPassBuilder builder(scene, probe);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) builder.instance(i);
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) builder.unseen_mesh(i);
  for (const auto& object : probe.objects)
    out.materials.push_back(
        {fmt::format("object {}", out.materials.size()), scene::Emission{object.radiance, {}}});
  for (std::size_t i = 0; i < out.lights.size(); ++i) {
    const int object = builder.new_object(fmt::format("light {}", or_number(out.lights[i].name, i)));
    out.lights[i].radiance = nth(probe.objects, object).radiance;
    out.lights[i].ies.reset();
  }
  return probe;
}

void write_ramps(const std::filesystem::path& exr, const std::filesystem::path& png) {
  auto image = image::make_image(kRampSize, kRampSize, {"R", "G", "B"});
  for (int y = 0; y < kRampSize; ++y)
    for (int x = 0; x < kRampSize; ++x) {
      image.at(x, y, 0) = (static_cast<float>(x) + 0.5F) / kRampSize;
      image.at(x, y, 1) = 1 - (static_cast<float>(y) + 0.5F) / kRampSize;
      image.at(x, y, 2) = 1;
    }
  image::write_exr(image, exr, image::Precision::Float, image::Compression::None);
  image::write_png(image::display_image(image), png);
}

namespace {

// The materials of meshes that have these coordinates.
std::set<int> objects_with_coordinates(const scene::Scene& scene, int uv_set) {
  std::set<int> objects;
  for (const auto& instance : scene.instances) {
    const scene::Mesh& mesh = mesh_of(scene, instance);
    if (uv_set == 1 && mesh.second_uvs.empty()) continue;
    for (const int material : mesh.triangle_materials) objects.insert(remapped(instance, material));
  }
  return objects;
}

template <typename Model>
scene::Scene with_ramp(const ProbeScene& probe, const std::filesystem::path& ramp, int uv_set) {
  scene::Scene out = probe.scene;
  const auto shown = objects_with_coordinates(out, uv_set);
  out.textures = {{"ramp", ramp}};
  for (std::size_t i = 0; i < out.materials.size(); ++i)
    out.materials[i].model = shown.contains(static_cast<int>(i))
                                 ? Model{{1, 1, 1}, scene::TextureUse{0, {}, uv_set}}
                                 : Model{{0, 0, 0}, {}};
  for (auto& light : out.lights) light.radiance = {};
  return out;
}

}  // namespace

scene::Scene make_uv_pass(const ProbeScene& probe, const std::filesystem::path& ramp, int uv_set) {
  return with_ramp<scene::Emission>(probe, ramp, uv_set);
}

scene::Scene make_reflecting_uv_pass(const ProbeScene& probe, const std::filesystem::path& ramp, int uv_set) {
  auto out = with_ramp<scene::Lambert>(probe, ramp, uv_set);
  out.environment = {.radiance = {1, 1, 1}};
  return out;
}

std::optional<ProbeScene> at_second_coordinates(const ProbeScene& probe) {
  bool is_any = false;
  ProbeScene out = probe;
  for (scene::Mesh& mesh : out.scene.meshes) {
    is_any = is_any || !mesh.second_uvs.empty();
    mesh.uvs = mesh.second_uvs.empty() ? std::vector<Vec2f>(mesh.positions.size()) : mesh.second_uvs;
  }
  return is_any ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace orbs::studies
