#include "adapters/mitsuba/mitsuba.h"

#include "adapters/detail_images.h"
#include "adapters/environment_image.h"
#include "adapters/format_limits.h"
#include "adapters/material_meshes.h"
#include "adapters/mitsuba/integrator.h"
#include "adapters/mitsuba/lights.h"
#include "adapters/mitsuba/materials.h"
#include "adapters/mitsuba/meshes.h"
#include "adapters/mitsuba/xml.h"
#include "adapters/tinted_image.h"
#include "adapters/xml_comment.h"
#include "base/files.h"
#include "base/nth.h"
#include "image/image_io.h"
#include "scene/camera_frame.h"
#include "scene/effects/effects.h"
#include "scene/geometry/ply.h"
#include "scene/lower/lower.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

using mitsuba::to_world;
using mitsuba::vector;

struct ClipDistances {
  double near_m;
  double far_m;
};

// The distance of the farthest vertex of each mesh and light from the camera.
std::vector<double> depths_m(const scene::Scene& scene, const std::vector<MaterialMesh>& meshes) {
  const Vec3d camera = scene.camera.position_m;
  std::vector<double> depths;
  for (const MaterialMesh& shown : meshes)
    for (const Mat4& place : shown.places) {
      double depth = 0;
      for (const Vec3f p : shown.mesh.positions)
        depth = std::max(depth, length(transform_point(place, cast<double>(p)) - camera));
      depths.push_back(depth);
    }
  for (const scene::Light& light : scene.lights) {
    if (!has_area(light.shape)) continue;
    const double scale = length(transform_direction(light.matrix, {1, 0, 0})) +
                         length(transform_direction(light.matrix, {0, 0, 1}));
    const Vec3d half = half_size(light.shape);
    depths.push_back(length(transform_point(light.matrix, {}) - camera) + scale * std::max(half.x, half.z));
  }
  return depths;
}

// Mitsuba's near and far planes clip, those of ORB.S do not. The near plane is a millionth of the scene's
// depth, the resolution of float coordinates there. The depth that counts is at most 1000 times that of the
// nearest object, so that a ground of 1000 km does not move the plane beyond what stands on it.
ClipDistances clip_distances(const scene::Scene& scene, const std::vector<MaterialMesh>& meshes) {
  const std::vector<double> depths = depths_m(scene, meshes);
  if (depths.empty()) return {2e-6, 2};
  const double farthest = *std::max_element(depths.begin(), depths.end());
  const double nearest = *std::min_element(depths.begin(), depths.end());
  return {2e-6 * std::min(farthest, 1000 * nearest), 2 * farthest};
}

// The plug-in, its own parameters, and what comes before the look-at.
struct SensorKind {
  std::string plugin;
  std::string parameters;
  std::string scale;
};

struct SensorKindOf {
  const scene::Camera& camera;

  // `fov` is along x by default. An offset of the principal point is one of the image's, downwards.
  SensorKind operator()(const scene::Perspective&) const {
    std::string text = fmt::format(
        "<float name=\"fov\" value=\"{}\"/><string name=\"fov_axis\" value=\"y\"/>", camera.fov_y_deg);
    if (scene::has_lens(camera))
      return {"thinlens",
              text + fmt::format("<float name=\"aperture_radius\" value=\"{}\"/>"
                                 "<float name=\"focus_distance\" value=\"{}\"/>",
                                 camera.aperture_radius_m, camera.focus_distance_m.value()),
              ""};
    if (scene::is_shifted(camera))
      text += fmt::format(
          "<float name=\"principal_point_offset_x\" value=\"{}\"/>"
          "<float name=\"principal_point_offset_y\" value=\"{}\"/>",
          camera.shift.x, -camera.shift.y);
    return {"perspective", text, ""};
  }
  // The image is 2 wide.
  SensorKind operator()(const scene::Orthographic&) const {
    const double half_width = scene::camera_frame(camera).half_width;
    return {"orthographic", "", fmt::format("<scale x=\"{0}\" y=\"{0}\"/>", half_width)};
  }
  SensorKind operator()(const scene::LatitudeLongitude&) const { return {}; }  // refused
};

// Mitsuba's look-at is right-handed as ours, so nothing is flipped.
std::string sensor_text(const scene::Camera& camera, ClipDistances clip) {
  const auto kind = std::visit(SensorKindOf{camera}, camera.projection);
  return fmt::format(
      "<sensor type=\"{}\">\n"
      "  {}\n"
      "  <float name=\"near_clip\" value=\"{}\"/><float name=\"far_clip\" value=\"{}\"/>\n"
      "  <transform name=\"to_world\">{}<lookat origin=\"{}\" target=\"{}\" up=\"{}\"/></transform>\n"
      "  <sampler type=\"independent\"><integer name=\"sample_count\" value=\"$spp\"/><integer "
      "name=\"seed\" value=\"$seed\"/></sampler>\n"
      "  <film type=\"hdrfilm\">\n"
      "    <integer name=\"width\" value=\"{}\"/><integer name=\"height\" value=\"{}\"/>\n"
      "    <string name=\"file_format\" value=\"openexr\"/><string name=\"pixel_format\" "
      "value=\"rgb\"/><string name=\"component_format\" value=\"float32\"/>\n"
      "    <rfilter type=\"box\"/>\n"
      "  </film>\n"
      "</sensor>\n",
      kind.plugin, kind.parameters, clip.near_m, clip.far_m, kind.scale, vector(camera.position_m),
      vector(camera.look_at_m), vector(camera.up), camera.width_px, camera.height_px);
}

// Mitsuba counts the texture rows of a PLY from the top, ORB.S from the bottom: v becomes 1 - v in the file,
// not by an option whose default differs between Mitsuba's mesh formats.
scene::Mesh flipped_v(scene::Mesh mesh) {
  for (Vec2f& uv : mesh.uvs) uv.y = static_cast<float>(1 - double{uv.y});
  return mesh;
}

class Writer {
 public:
  Writer(const scene::Scene& scene, const std::filesystem::path& file)
      : scene_(scene),
        colours_(scene),
        folder_(file.parent_path()),
        stem_(file.stem().string()),
        meshes_(split_by_frames(scene, material_meshes(scene))) {}

  std::string write() {
    std::string text = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<scene version=\"3.0.0\">\n";
    text += "<default name=\"spp\" value=\"64\"/>\n<default name=\"seed\" value=\"0\"/>\n";
    text += mitsuba::integrator_text(scene_) + sensor_text(scene_.camera, clip_distances(scene_, meshes_));
    if (scene_.environment.map)
      text += environment_map_text();
    else if (shines(scene_.environment))
      text += fmt::format("<emitter type=\"constant\">{}</emitter>\n",
                          colours_.radiance(scene_.environment.radiance, scene_.environment.spectrum));
    for (const int material : scene::visible_materials(scene_)) text += material_text(material);
    for (std::size_t i = 0; i < meshes_.size(); ++i) text += mesh_text(meshes_[i], i);
    for (const scene::Light& light : scene_.lights) text += mitsuba::light_text(colours_, light);
    return text + "</scene>\n";
  }

 private:
  std::string environment_map_text() const {
    const auto name = fmt::format("{}-environment.exr", stem_);
    const TurnedEnvironment map = turned_environment(scene_);
    image::write_exr(mitsuba::rows_on_poles(map.image), folder_ / name);
    return mitsuba::environment_map(name, map.matrix);
  }

  std::string material_text(int index) {
    if (scene::texture_of(material_at(scene_, index).model))
      write_tinted(scene_, index, folder_ / tinted_image_name(index, stem_));
    write_detail_images(scene_, index, folder_ / (stem_ + ".xml"), MirrorImages::None);
    std::string text = mitsuba::bsdf_text(colours_, index, stem_, false);
    const bool is_mirrored = std::any_of(meshes_.begin(), meshes_.end(), [&](const MaterialMesh& shown) {
      return shown.material == index && shown.is_mirrored;
    });
    if (is_mirrored) text += mitsuba::bsdf_text(colours_, index, stem_, true);
    return text;
  }

  std::string mesh_text(const MaterialMesh& shown, std::size_t index) {
    const auto& model = material_at(scene_, shown.material).model;
    const auto bsdf = mitsuba::bsdf_id(shown.material, shown.is_mirrored);
    std::string text = xml_comment(shown.mesh.name);
    if (const auto* emission = std::get_if<scene::Emission>(&model)) {
      for (std::size_t i = 0; i < shown.places.size(); ++i)
        text += shape(mitsuba::emitting_mesh(scene_, shown.mesh, shown.places[i]),
                      fmt::format("mesh{}.{}", index, i), bsdf,
                      "<boolean name=\"face_normals\" value=\"true\"/>" +
                          mitsuba::area_emitter(colours_, emission->radiance, emission->spectrum) +
                          to_world(shown.places[i]));
      return text;
    }
    if (const auto* polariser = std::get_if<scene::Polariser>(&model)) {
      for (std::size_t i = 0; i < shown.places.size(); ++i)
        text += shape(mitsuba::polariser_mesh(polariser->axis, shown.mesh, shown.places[i]),
                      fmt::format("mesh{}.{}", index, i), bsdf, "");
      return text;
    }
    const std::string name = fmt::format("mesh{}", index);
    // A mesh that a matrix mirrors has its triangles the other way round than its vertex normals: Mitsuba's
    // bump maps take the side of the triangles. Within an instance both are mirrored together.
    const bool is_turned_over =
        turns_normals(material_at(scene_, shown.material).detail) && determinant3(shown.places.front()) < 0;
    if (shown.places.size() == 1 && !is_turned_over)
      return text + shape(flipped_v(shown.mesh), name, bsdf, to_world(shown.places[0]));
    text += fmt::format("<shape type=\"shapegroup\" id=\"{}\">\n{}</shape>\n", name,
                        shape(flipped_v(shown.mesh), name, bsdf, ""));
    for (const Mat4& place : shown.places)
      text += fmt::format("<shape type=\"instance\"><ref id=\"{}\"/>{}</shape>\n", name, to_world(place));
    return text;
  }

  std::string shape(const scene::Mesh& mesh,
                    const std::string& name,
                    const std::string& bsdf,
                    const std::string& more) const {
    const std::string ply = fmt::format("{}-{}.ply", stem_, name);
    scene::write_ply(mesh, folder_ / ply, scene::PlyContent::Common);
    return fmt::format(
        "<shape type=\"ply\"><string name=\"filename\" value=\"{}\"/><ref id=\"{}\"/>{}</shape>\n", ply, bsdf,
        more);
  }

  const scene::Scene& scene_;
  mitsuba::Colours colours_;
  std::filesystem::path folder_;
  std::string stem_;
  std::vector<MaterialMesh> meshes_;
};

}  // namespace

void write_mitsuba(const scene::Scene& scene, const std::filesystem::path& file) {
  write_file(file, Writer(scene, file).write());
}

Exporter mitsuba_exporter() {
  return {.format = "mitsuba",
          .scene_file = "scene.xml",
          .settings = {},
          .limits = [](const scene::Scene& scene, const SceneSettings&) { return mitsuba_limits(scene); },
          .write = [](const scene::Scene& scene, const SceneSettings&,
                      const std::filesystem::path& file) { write_mitsuba(scene, file); }};
}

namespace {

constexpr const char* kName = "Mitsuba";

// Mitsuba's emitter is dark from behind; ORB.S's emissive surfaces shine from both sides.
std::string back_limit(const scene::Scene& scene, const MaterialMesh& shown) {
  const auto& material = material_at(scene, shown.material);
  if (!std::holds_alternative<scene::Emission>(material.model) || mitsuba::only_camera_sees_light(scene))
    return "";
  if (!is_closed(shown.mesh))
    return fmt::format(
        "mesh '{}' emits ('{}') and is not closed: Mitsuba's emitters shine from one side only",
        shown.mesh.name, material.name);
  const bool inside = std::any_of(shown.places.begin(), shown.places.end(), [&](const Mat4& place) {
    return encloses(shown.mesh, transform_point(inverse(place).value(), scene.camera.position_m));
  });
  if (!inside) return "";
  return fmt::format("the camera is inside of mesh '{}', which emits: Mitsuba's emitters shine outwards only",
                     shown.mesh.name);
}

// It hides all of them from the camera, and nothing from mirrors.
std::string hidden_limit(const scene::Scene& scene) {
  if (scene.environment.visible_to_camera) return "";
  const auto emits = [&](int material) {
    return std::holds_alternative<scene::Emission>(material_at(scene, material).model);
  };
  const auto shown = scene::visible_materials(scene);
  const bool has_more = std::any_of(shown.begin(), shown.end(), emits) ||
                        std::any_of(scene.lights.begin(), scene.lights.end(),
                                    [](const auto& light) { return has_area(light.shape); });
  return has_more ? "the camera does not see the environment: Mitsuba hides all emitters, or none" : "";
}

std::string camera_limit(const scene::Camera& camera) {
  if (scene::has_lens(camera) && scene::is_shifted(camera))
    return "the camera has a lens that is shifted: Mitsuba's lenses are centred";
  return "";
}

}  // namespace

std::vector<std::string> mitsuba_limits(const scene::Scene& scene) {
  std::vector<std::string> reasons = beyond_orbs_limits(scene, kName, mitsuba::beyond_orbs());
  const auto note = [&](const std::string& reason) {
    if (!reason.empty()) reasons.push_back(reason);
  };
  const auto transport = scene::transport(scene);
  std::set<int> textures;
  for (const int index : scene::visible_materials(scene)) {
    const scene::Material& material = material_at(scene, index);
    note(mitsuba::material_limit(material, transport == scene::LightTransport::Polarised));
    note(scene::texture_matrices_problem(scene, index));
    note(uv_set_limit(scene, index, kName));
    for (const scene::TextureUse& use : scene::texture_uses(material)) textures.insert(use.texture);
  }
  for (const int index : textures) {
    const auto& texture = nth(scene.textures, index);
    note(wrap_limit(texture, kName));
    if (transport != scene::LightTransport::Rgb) note(spectral_texture_limit(texture, kName));
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    note(mitsuba::light_limit(scene.lights[i], scene::display_name("light", scene.lights[i].name, i)));
  for (const MaterialMesh& shown : material_meshes(scene)) note(back_limit(scene, shown));
  note(hidden_limit(scene));
  note(camera_limit(scene.camera));
  note(mitsuba::stokes_limit(scene));
  note(mitsuba::layer_limit(scene.outputs));
  return reasons;
}

}  // namespace orbs::adapters
