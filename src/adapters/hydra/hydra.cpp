#include "adapters/hydra/hydra.h"

#include "adapters/environment_image.h"
#include "adapters/format_limits.h"
#include "adapters/hydra/ies.h"
#include "adapters/hydra/lights.h"
#include "adapters/hydra/materials.h"
#include "adapters/hydra/remap_lists.h"
#include "adapters/hydra/textures.h"
#include "adapters/hydra/vsgf.h"
#include "adapters/hydra/xml.h"
#include "adapters/xml_comment.h"
#include "base/files.h"
#include "base/nth.h"
#include "scene/camera_frame.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace orbs::adapters {

HydraPaths hydra_paths(const scene::Scene& scene, const SceneSettings& settings) {
  const auto naive = settings.find("naive");
  if (naive != settings.end() && naive->second != 0) return {scene.trace_depth, false};
  const bool samples_sun = scene.environment.map && has_sun(scene);
  if (scene.trace_depth == 1 && !samples_sun) return {2, true};
  const bool is_found_behind = !samples_sun && (scene.lights.empty() || shines(scene.environment));
  return {is_found_behind ? scene.trace_depth + 1 : scene.trace_depth, false};
}

namespace {

using hydra::numbers;
using hydra::value_node;

// A lens is in focus at the point that it looks at.
std::string lens_text(const scene::Camera& camera) {
  return scene::has_lens(camera)
             ? value_node("enable_dof", 1) + value_node("dof_lens_radius", camera.aperture_radius_m)
             : "";
}

Vec3d look_at(const scene::Camera& camera) {
  if (!scene::has_lens(camera)) return camera.look_at_m;
  return camera.position_m + scene::camera_frame(camera).forward * camera.focus_distance_m.value();
}

// The planes do not clip; `near` must not be 0.
std::string camera_text(const scene::Camera& camera) {
  return "<camera id=\"0\">\n" + value_node("fov", camera.fov_y_deg) +
         value_node("nearClipPlane", camera.near_m) + value_node("farClipPlane", camera.far_m) + "\n" +
         value_node("up", camera.up) + value_node("position", camera.position_m) +
         value_node("look_at", look_at(camera)) + lens_text(camera) + "\n</camera>\n";
}

std::string settings_text(const scene::Camera& camera, int trace_depth) {
  return "<render_settings id=\"0\">\n" + value_node("width", camera.width_px) +
         value_node("height", camera.height_px) + value_node("trace_depth", trace_depth) +
         value_node("maxRaysPerPixel", 64) + "\n</render_settings>\n";
}

std::string library(const char* name, const std::string& nodes) {
  return fmt::format("<{0}>\n{1}</{0}>\n", name, nodes);
}

class Writer {
 public:
  Writer(const scene::Scene& scene, const std::filesystem::path& file)
      : scene_(scene), folder_(file.parent_path()), stem_(file.stem().string()) {}

  // All libraries must be there, empty or not.
  std::string write(int trace_depth) {
    auto textures = hydra::write_textures(scene_, folder_, stem_);
    std::string materials = hydra::material_nodes(scene_, textures);
    const auto light_count = static_cast<int>(scene_.lights.size());
    const auto material_count = static_cast<int>(scene_.materials.size());
    const auto remaps = hydra::remap_lists(scene_, material_count + light_count - 1);
    for (std::size_t i = 0; i < scene_.instances.size(); ++i)
      add_instance(scene_.instances[i], remaps.of_instances[i]);
    for (int i = 0; i < light_count; ++i) {
      materials += hydra::light_material_node(nth(scene_.lights, i), material_count + i, i);
      add_light(nth(scene_.lights, i), i, material_count + i);
    }
    if (shines(scene_.environment)) {
      lights_ += sky_text(textures, light_count);
      add_light_instance(light_count, Mat4{});
    }
    const std::string scene_node =
        "<scene id=\"0\">\n" + remaps.text + instances_ + light_instances_ + "</scene>\n";
    return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n" +
           library("root", library("textures_lib", textures.text) + library("materials_lib", materials) +
                               library("geometry_lib", meshes_) + library("lights_lib", lights_) +
                               library("cam_lib", camera_text(scene_.camera)) +
                               library("render_lib", settings_text(scene_.camera, trace_depth)) +
                               library("scenes", scene_node));
  }

 private:
  std::string sky_text(hydra::TextureLibrary& textures, int position) const {
    hydra::Sky sky{.radiance = scene_.environment.radiance};
    if (!scene_.environment.map && scene_.environment.visible_to_camera)
      return hydra::sky_node(sky, position);
    if (scene_.environment.map) {
      sky.radiance = {1, 1, 1};  // it is in the image
      sky.map = hydra::add_image(textures, hydra::sky_image(environment_in_world(scene_)), folder_,
                                 stem_ + "-environment");
    }
    // HydraCore3 reads of a sky's texture at the place behind it in the library: there must be one.
    const int black =
        hydra::add_image(textures, image::make_image(1, 1, {"R", "G", "B"}), folder_, stem_ + "-black");
    if (!scene_.environment.visible_to_camera) sky.back = black;
    return hydra::sky_node(sky, position);
  }

  // The position of the mesh in geometry_lib.
  int add_mesh(const scene::Mesh& mesh, int first_material) {
    const int position = mesh_count_++;
    const auto name = fmt::format("{}-mesh{}.vsgf", stem_, position);
    const std::string bytes = hydra::vsgf_bytes(mesh, first_material);
    write_file(folder_ / name, bytes);
    meshes_ +=
        xml_comment(mesh.name) +
        fmt::format(
            "<mesh id=\"{}\" type=\"vsgf\" loc=\"{}\" vertNum=\"{}\" triNum=\"{}\" bytesize=\"{}\"/>\n",
            position, name, mesh.positions.size(), mesh.triangles.size(), bytes.size());
    return position;
  }

  void add_mesh_instance(int mesh, int remap_list, const Mat4& matrix, const std::string& more) {
    instances_ += fmt::format("<instance id=\"{}\" mesh_id=\"{}\" rmap_id=\"{}\" matrix=\"{}\"{}/>\n",
                              instance_count_++, mesh, remap_list, numbers(matrix), more);
  }

  // A mesh without instances is not written.
  void add_instance(const scene::Instance& instance, int remap_list) {
    const auto [found, is_new] = positions_.try_emplace(instance.mesh, mesh_count_);
    if (is_new) add_mesh(mesh_of(scene_, instance), 0);
    add_mesh_instance(found->second, remap_list, instance.matrix, "");
  }

  void add_light(const scene::Light& light, int position, int material) {
    const auto ies_file = fmt::format("{}-light{}.ies", stem_, position);
    if (light.ies) write_file(folder_ / ies_file, hydra::ies_grid(*light.ies->profile).text);
    lights_ += hydra::light_node(light, position, ies_file, bright_lights());
    add_light_instance(position, light.matrix);
    if (!has_area(light.shape)) return;
    add_mesh_instance(add_mesh(hydra::light_mesh(light), material), -1, light.matrix,
                      fmt::format(" linst_id=\"{}\"", position));
  }

  int bright_lights() const {
    const auto is_bright = [](scene::RgbColour emission) { return emission != scene::RgbColour{}; };
    const auto count = std::count_if(scene_.lights.begin(), scene_.lights.end(),
                                     [&](const auto& light) { return is_bright(light.radiance); });
    return static_cast<int>(count) + (scene::shines(scene_.environment) ? 1 : 0);
  }

  void add_light_instance(int light, const Mat4& matrix) {
    light_instances_ +=
        fmt::format("<instance_light id=\"{0}\" light_id=\"{0}\" matrix=\"{1}\"/>\n", light, numbers(matrix));
  }

  const scene::Scene& scene_;
  std::filesystem::path folder_;
  std::string stem_;
  std::string meshes_;
  std::string lights_;
  std::string instances_;
  std::string light_instances_;
  std::map<int, int> positions_;  // of the scene's meshes in geometry_lib
  int mesh_count_ = 0;
  int instance_count_ = 0;
};

}  // namespace

void write_hydra(const scene::Scene& scene,
                 const SceneSettings& settings,
                 const std::filesystem::path& file) {
  write_file(file, Writer(scene, file).write(hydra_paths(scene, settings).trace_depth));
}

Exporter hydra_exporter() {
  return {.format = "hydra",
          .scene_file = "hydra.xml",
          .settings = {{"naive", true}},
          .limits = [](const scene::Scene& scene,
                       const SceneSettings& settings) { return hydra_limits(scene, settings); },
          .write = [](const scene::Scene& scene, const SceneSettings& settings,
                      const std::filesystem::path& file) { write_hydra(scene, settings, file); },
          .placeholders =
              [](const scene::Scene& scene, const SceneSettings& settings, int) {
                return registry::Placeholders{
                    {"layer", hydra_paths(scene, settings).is_direct ? "direct" : "color"}};
              }};
}

namespace {

bool is_naive(const SceneSettings& settings) {
  const auto naive = settings.find("naive");
  return naive != settings.end() && naive->second != 0;
}

}  // namespace

std::vector<std::string> hydra_limits(const scene::Scene& scene, const SceneSettings& settings) {
  constexpr const char* kName = "HydraCore3";
  std::vector<std::string> reasons = beyond_orbs_limits(scene, kName, hydra::beyond_orbs());
  const auto note = [&](const std::string& reason) {
    if (!reason.empty()) reasons.push_back(reason);
  };
  for (const int index : scene::visible_materials(scene))
    note(hydra::material_limit(material_at(scene, index)));
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    note(hydra::light_limit(scene.lights[i], scene::display_name("light", scene.lights[i].name, i)));
  const bool has_points = std::any_of(scene.lights.begin(), scene.lights.end(),
                                      [](const auto& light) { return !has_area(light.shape); });
  if (is_naive(settings) && has_points)
    reasons.emplace_back("a light has no area, and naive paths find what they meet alone");
  if (scene.trace_depth >= scene::kUnlimitedDepth)
    reasons.emplace_back(
        "the trace depth is unlimited: HydraCore3 has no Russian roulette to end such paths");
  if (scene.instances.empty() && scene.lights.empty())
    reasons.emplace_back("the scene has no mesh: HydraCore3 traces no ray without one");
  return reasons;
}

}  // namespace orbs::adapters
