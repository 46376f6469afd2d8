#include "adapters/povray/povray.h"

#include "adapters/detail_images.h"
#include "adapters/environment_image.h"
#include "adapters/exporter.h"
#include "adapters/format_limits.h"
#include "adapters/mirrored_image.h"
#include "adapters/povray/dispersion.h"
#include "adapters/povray/lights.h"
#include "adapters/povray/materials.h"
#include "adapters/povray/meshes.h"
#include "adapters/povray/sdl.h"
#include "adapters/povray/shapes.h"
#include "base/error.h"
#include "base/files.h"
#include "base/nth.h"
#include "image/image_io.h"
#include "scene/camera_frame.h"
#include "scene/relations/geometry.h"
#include "scene/relations/motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

using povray::colour;
using povray::vector;

constexpr int kMostRecursions = 20;  // of radiosity, a limit of POV-Ray 3.7
constexpr int kMostHalvings = 9;     // of a pixel
constexpr int kMostTraceLevels =
    256;  // another one; what is left of a ray after 100 mirrors is adc_bailout's

// Vectors instead of look_at and angle: POV-Ray's own frame is left-handed and its angle horizontal. `right`
// has the length of the image's width, `up` of its height, `direction` of the distance of that window.
struct CameraVectors {
  std::string kind;  // a line, with its angle
  Vec3d direction;
  Vec3d right;
  Vec3d up;
  std::string more;
};

struct CameraText {
  const scene::Camera& camera;
  scene::CameraFrame frame;

  // A direction that is oblique to right and up shifts the window.
  CameraVectors operator()(const scene::Perspective&) const {
    const double aspect = static_cast<double>(camera.width_px) / camera.height_px;
    Vec3d direction = frame.forward;
    if (scene::is_shifted(camera)) direction += frame.right * frame.centre.x + frame.up * frame.centre.y;
    return {"", direction * (0.5 / frame.half_height), frame.right * aspect, frame.up,
            scene::has_lens(camera) ? lens() : ""};
  }
  CameraVectors operator()(const scene::Orthographic&) const {
    return {"  orthographic\n", frame.forward, frame.right * (2 * frame.half_width),
            frame.up * (2 * frame.half_height), ""};
  }
  // POV-Ray turns to the left and downwards.
  CameraVectors operator()(const scene::LatitudeLongitude&) const {
    return {"  spherical angle 360 180\n", frame.forward, -frame.right, -frame.up, ""};
  }

  // The width of POV-Ray's disk is half of its aperture, and a variance of 0 takes all of the samples: with
  // 2000 its irregular grid is a disk to 0.006 of the light, below 37 it is a hexagon.
  std::string lens() const {
    constexpr int kSamples = 2000;
    const Vec3d focus = camera.position_m + frame.forward * camera.focus_distance_m.value();
    return fmt::format("  aperture {} focal_point {} variance 0 blur_samples {}\n",
                       4 * camera.aperture_radius_m, vector(focus), kSamples);
  }
};

std::string camera_text(const scene::Camera& camera) {
  const auto made = std::visit(CameraText{camera, scene::camera_frame(camera)}, camera.projection);
  return fmt::format("camera {{\n{}  location {}\n  direction {}\n  right {}\n  up {}\n{}}}\n", made.kind,
                     vector(camera.position_m), vector(made.direction), vector(made.right), vector(made.up),
                     made.more);
}

// What a light sheds on a surface needs no gathering, as it is a light_source; the light of the sky and of
// glowing surfaces is found by gathering alone, which takes one recursion more for as many reflections. Where
// a scene has both, the lights come first: their last reflection is there, that of the sky is missing.
int recursions_of(const scene::Scene& scene) {
  const int reflections_gathered = scene.lights.empty() ? scene.trace_depth : scene.trace_depth - 1;
  return std::min(reflections_gathered, kMostRecursions);
}

std::string radiosity_text(const scene::Scene& scene, const PovrayRadiosity& r) {
  const int recursions = recursions_of(scene);
  if (recursions < 1) return "";
  return fmt::format(
      "  radiosity {{\n"
      "    count {} error_bound {} low_error_factor {} nearest_count {} recursion_limit {}\n"
      "    pretrace_start {} pretrace_end {} minimum_reuse {} maximum_reuse {} always_sample {}\n"
      "    brightness 1 gray_threshold 0 adc_bailout 1e-6 normal off\n"
      "  }}\n",
      r.count, r.error_bound, r.low_error_factor, r.nearest_count, recursions, r.pretrace_start,
      r.pretrace_end, r.minimum_reuse, r.maximum_reuse, r.always_sample ? "on" : "off");
}

bool is_power_of_two(int n) { return n > 0 && (n & (n - 1)) == 0; }

void check_settings(const PovraySettings& settings) {
  if (!is_power_of_two(settings.area_grid) || !is_power_of_two(settings.area_split))
    throw InputError(fmt::format("POV-Ray: area_grid is {} and area_split is {}; expected powers of two",
                                 settings.area_grid, settings.area_split));
  if (settings.dispersion_samples < 2)
    throw InputError(
        fmt::format("POV-Ray: dispersion_samples is {}; expected at least 2", settings.dispersion_samples));
  if (settings.aa_depth < 0 || settings.aa_depth > kMostHalvings)
    throw InputError(
        fmt::format("POV-Ray: aa_depth is {}; expected at most {}", settings.aa_depth, kMostHalvings));
  if (settings.area_grid < 2 * settings.area_split)
    throw InputError(fmt::format("POV-Ray: area_grid is {}; expected at least twice area_split, {}",
                                 settings.area_grid, 2 * settings.area_split));
}

bool disperses(const scene::Material& material) {
  const auto* glass = std::get_if<scene::Dielectric>(&material.model);
  return glass && scene::is_dispersive(*glass);
}

std::string photons_text(const scene::Scene& scene, const PovraySettings& settings) {
  if (settings.photons == 0) return "";
  const bool splits = std::any_of(scene.materials.begin(), scene.materials.end(), disperses);
  const int aimed = splits ? settings.photons / settings.dispersion_samples : settings.photons;
  return fmt::format("  photons {{ count {} }}\n", std::max(aimed, 1));
}

// POV-Ray counts the camera ray as level 1, so level n + 1 is reached after n mirrors. A ray that passes
// through an opening goes on at its own level, but none goes on at the last one: a gathered ray ended at the
// first sheet, and a floor below it was black. Where nothing reflects or refracts, the levels bound nothing
// else.
int trace_levels(const scene::Scene& scene) {
  const auto& all = scene.materials;
  const bool passes = std::any_of(
      all.begin(), all.end(), [](const auto& material) { return scene::lets_rays_pass(material.detail); });
  const bool turns = std::any_of(
      all.begin(), all.end(), [](const auto& material) { return povray::is_photon_target(material.model); });
  return passes && !turns ? kMostTraceLevels : std::min(scene.trace_depth + 1, kMostTraceLevels);
}

std::string settings_text(const scene::Scene& scene, const PovraySettings& settings) {
  return fmt::format(
      "#version 3.7;\n"
      "global_settings {{\n"
      "  assumed_gamma 1.0\n"
      "  max_trace_level {}\n"
      "  adc_bailout 1e-5\n"
      "{}{}}}\n"
      "#default {{ finish {{ ambient 0 diffuse 1 emission 0 specular 0 phong 0 }} }}\n",
      trace_levels(scene), radiosity_text(scene, settings.radiosity), photons_text(scene, settings));
}

// What belongs to a whole object of mirror or glass.
std::string photon_target_text(const scene::Scene& scene, int material, const PovraySettings& settings) {
  std::string text;
  const auto& model = material_at(scene, material).model;
  if (const auto* glass = std::get_if<scene::Glass>(&model))
    text += fmt::format(" interior {{ ior {} }}", glass->ior);
  if (const auto* glass = std::get_if<scene::Dielectric>(&model)) {
    const auto [ior, dispersion] = povray::dispersion_of(*glass);
    text += fmt::format(" interior {{ ior {} dispersion {} dispersion_samples {} }}", ior, dispersion,
                        settings.dispersion_samples);
  }
  if (settings.photons > 0) text += " photons { target reflection on refraction on collect off }";
  return text;
}

std::string object_text(const scene::Scene& scene,
                        const scene::Instance& instance,
                        const povray::DeclaredMesh& mesh,
                        const PovraySettings& settings) {
  const auto extras = mesh.material < 0 ? "" : photon_target_text(scene, mesh.material, settings);
  return fmt::format("object {{ {} {}{} }}\n", mesh.name, povray::matrix(instance.matrix), extras);
}

std::string shape_text(const scene::Scene& scene, const scene::Shape& shape, const PovraySettings& settings) {
  const auto material = povray::photon_material(scene, shape);
  return fmt::format("// shape {}\n{}{} }}\n", comment_text(shape.name), povray::open_shape_text(shape),
                     material ? photon_target_text(scene, *material, settings) : "");
}

// Spheres without a matrix as the other shapes.
std::vector<scene::Shape> all_shapes(const scene::Scene& scene) {
  std::vector<scene::Shape> shapes;
  for (const auto& sphere : scene.spheres)
    shapes.push_back({sphere.name, scene::SphereForm{sphere.centre_m, sphere.radius_m}, {}, sphere.material});
  shapes.insert(shapes.end(), scene.shapes.begin(), scene.shapes.end());
  return shapes;
}

struct Text {
  std::string scene;
  povray::MeshLibrary meshes;
  std::set<int> textures;
};

Text scene_text(const scene::Scene& scene, const PovraySettings& settings, const std::string& stem) {
  Text text;
  std::string objects;
  for (const scene::Instance& instance : scene.instances) {
    objects += fmt::format("// instance {}\n", comment_text(instance.name));
    for (const auto& mesh : povray::declared_meshes(scene, instance, text.meshes))
      objects += object_text(scene, instance, mesh, settings);
  }
  for (const scene::Shape& shape : all_shapes(scene)) objects += shape_text(scene, shape, settings);
  text.scene =
      settings_text(scene, settings) + camera_text(scene.camera) + povray::environment_text(scene, stem);
  for (const int index : scene::visible_materials(scene)) {
    const scene::Material& material = material_at(scene, index);
    text.scene += fmt::format("// material {}\n", comment_text(material.name)) +
                  povray::material_declaration(scene, index, stem);
    if (const auto& use = scene::texture_of(material.model)) text.textures.insert(use->texture);
  }
  if (!text.meshes.text.empty()) text.scene += fmt::format("#include \"{}-meshes.inc\"\n", stem);
  text.scene += objects;
  for (const scene::Light& light : scene.lights)
    text.scene +=
        fmt::format("// light {}\n", comment_text(light.name)) + povray::light_text(scene, light, settings);
  return text;
}

// POV-Ray's tolerances are absolute (MIN_ISECT_DEPTH and SMALL_TOLERANCE of its source, 1e-4 and 1e-3): a
// block of 5 mm loses its shadow, one of 50 mm on does not. No radiance depends on a scale.
scene::Scene enlarged(const scene::Scene& scene) {
  constexpr double kLeastRadius_m = 1;
  constexpr double kMargin = 16;
  const double factor = scene::rescaling_into(scene, kLeastRadius_m, std::numeric_limits<double>::infinity());
  if (factor == 1) return scene;
  const double all = kMargin * factor;
  return scene::moved(scene, scaling({all, all, all}));
}

}  // namespace

int povray_aa_grid(int spp) {
  int depth = 4;  // POV-Ray takes 1 to 9
  while (depth < kMostHalvings && spp > 1 << (2 * depth)) ++depth;
  return depth;
}

std::string povray_antialiasing(const scene::Scene& scene) {
  return scene::has_lens(scene.camera) ? "-A" : "+A0.05";
}

namespace {

// A copy of the file, or the image with its mirror images: POV-Ray's images repeat and are not mirrored.
void write_texture(const scene::Texture& texture, const std::filesystem::path& copy) {
  if (!is_mirrored(texture)) {
    write_file(copy, read_file(texture.file));
    return;
  }
  const auto image = with_mirror_images(image::read_image(texture.file), texture);
  image::is_float_format(texture.file) ? image::write_exr(image, copy) : image::write_png(image, copy);
}

}  // namespace

void write_povray(const scene::Scene& given,
                  const PovraySettings& settings,
                  const std::filesystem::path& file) {
  check_settings(settings);
  const scene::Scene scene = enlarged(given);
  const std::string stem = file.stem().string();
  const std::filesystem::path folder = file.parent_path();
  const Text text = scene_text(scene, settings, stem);
  for (const int index : text.textures) {
    const scene::Texture& texture = nth(scene.textures, index);
    with_note(fmt::format("copying texture '{}' for POV-Ray", texture.name),
              [&] { write_texture(texture, folder / povray::texture_copy(scene, index, stem)); });
  }
  for (const int index : scene::visible_materials(scene))
    write_detail_images(scene, index, file, MirrorImages::Beside);
  if (scene.environment.map)
    image::write_exr(turned_environment(scene).image, folder / povray::environment_file(stem));
  if (!text.meshes.text.empty()) write_file(folder / (stem + "-meshes.inc"), text.meshes.text);
  write_file(file, text.scene);
}

Exporter povray_exporter() {
  return {
      .format = "povray",
      .scene_file = "scene.pov",
      .settings = povray_setting_names(),
      .limits = [](const scene::Scene& scene,
                   const SceneSettings& numbers) { return povray_limits(scene, povray_settings(numbers)); },
      .write = [](const scene::Scene& scene, const SceneSettings& numbers,
                  const std::filesystem::path& file) { write_povray(scene, povray_settings(numbers), file); },
      .placeholders =
          [](const scene::Scene& scene, const SceneSettings& numbers, int spp) {
            const int asked = povray_settings(numbers).aa_depth;
            const int depth = asked > 0 ? asked : povray_aa_grid(spp);
            return registry::Placeholders{{"aa_grid", std::to_string(depth)},
                                          {"antialiasing", povray_antialiasing(scene)}};
          }};
}

namespace {

std::string texture_limit(const scene::Texture& texture) {
  const std::string type = povray::image_type(texture.file);
  if (type.empty())
    return fmt::format("texture '{}' is a {} file, which POV-Ray does not read", texture.name,
                       texture.file.extension().string());
  if (unmirrored(texture).wrap_u != unmirrored(texture).wrap_v && type != "png")
    return fmt::format(
        "texture '{}' is clamped along one axis only, which the exporter can do for PNG files alone",
        texture.name);
  return "";
}

// Light that a mirror or glass sends to a diffuse surface needs photons, and only light sources emit photons.
bool needs_caustics(const scene::Scene& scene, const std::set<int>& materials) {
  if (scene.trace_depth < 2 || scene.lights.empty()) return false;
  bool has_diffuse = false;
  bool has_specular = false;
  for (const int material : materials) {
    const scene::MaterialModel& model = material_at(scene, material).model;
    has_specular = has_specular || povray::is_photon_target(model);
    has_diffuse = has_diffuse || povray::surface_of(model) == povray::Surface::Diffuse;
  }
  return has_diffuse && has_specular;
}

}  // namespace

std::vector<std::string> povray_limits(const scene::Scene& scene, const PovraySettings& settings) {
  std::vector<std::string> reasons = beyond_orbs_limits(scene, "POV-Ray", povray::beyond_orbs());
  const auto note = [&](const std::string& reason) {
    if (!reason.empty()) reasons.push_back(reason);
  };
  const std::set<int> materials = scene::visible_materials(scene);
  std::set<int> textures;
  for (const int index : materials) {
    const scene::Material& material = material_at(scene, index);
    note(povray::material_limit(scene, material));
    for (const scene::TextureUse& use : texture_uses(material)) textures.insert(use.texture);
  }
  for (const int texture : textures) note(texture_limit(nth(scene.textures, texture)));
  for (std::size_t i = 0; i < scene.shapes.size(); ++i)
    note(povray::shape_limit(scene, scene.shapes[i],
                             scene::display_name("shape", scene.shapes[i].name, scene.spheres.size() + i)));
  for (const auto& sphere : scene.spheres)
    if (texture_of(material_at(scene, sphere.material).model))
      note("a sphere by its formula has a texture: POV-Ray's shapes have different texture coordinates");
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    note(povray::light_limit(scene.lights[i], scene::display_name("light", scene.lights[i].name, i)));
  if (scene.environment.map && has_sun(scene))
    note(
        "the environment has a sun: POV-Ray's radiosity looks in directions that do not follow the sky's "
        "brightness");
  if (settings.photons == 0 && needs_caustics(scene, materials))
    note(
        "a mirror or glass throws light on diffuse surfaces, which takes photons, and they are switched off");
  return reasons;
}

}  // namespace orbs::adapters
