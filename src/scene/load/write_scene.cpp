#include "scene/load/write_scene.h"

#include "base/files.h"
#include "json/writer.h"
#include "scene/effects/switches.h"
#include "scene/geometry/ply.h"
#include "scene/geometry/subdivision/entry.h"
#include "scene/load/spectra.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

using json::Writer;

struct WriteProjection {
  Writer& out;
  const Camera& camera;

  void operator()(const Perspective&) const {
    out.member("fov_y", camera.fov_y_deg);
    if (camera.shift != Vec2d{}) out.key("shift").numbers(std::array{camera.shift.x, camera.shift.y});
    if (camera.aperture_radius_m > 0) out.member("aperture_radius", camera.aperture_radius_m);
  }
  void operator()(const Orthographic& kind) const {
    out.member("projection", kind.kType).member("view_height", kind.height_m);
  }
  void operator()(const LatitudeLongitude& kind) const { out.member("projection", kind.kType); }
};

void write_camera(Writer& out, const Camera& camera) {
  out.key("camera").begin_object();
  out.member("position", camera.position_m).member("look_at", camera.look_at_m).member("up", camera.up);
  std::visit(WriteProjection{out, camera}, camera.projection);
  out.member("width", camera.width_px).member("height", camera.height_px);
  out.member("near", camera.near_m).member("far", camera.far_m);
  if (camera.focus_distance_m) out.member("focus_distance", *camera.focus_distance_m);
  if (camera.shutter != Shutter{})
    out.key("shutter").numbers(std::array{camera.shutter.open, camera.shutter.close});
  if (camera.end) {
    out.key("end").begin_object().member("position", camera.end->position_m);
    out.member("look_at", camera.end->look_at_m).member("up", camera.end->up).end_object();
  }
  out.end_object();
}

void write_model(Writer& out, const Scene& scene, const MaterialModel& model) {
  out.member("type", type_name(model));
  std::visit([&](const auto& m) { write(out, scene.spectra, m); }, model);
}

void write_materials(Writer& out, const Scene& scene) {
  out.key("textures").begin_array();
  for (const auto& texture : scene.textures) {
    out.begin_object().member("name", texture.name).member("file", texture.file.string());
    out.member("wrap_u", word_of(texture.wrap_u)).member("wrap_v", word_of(texture.wrap_v));
    if (texture.filter != Filter::Linear) out.member("filter", word_of(texture.filter));
    if (texture.encoding == Encoding::Linear) out.member("encoding", "linear");
    out.end_object();
  }
  out.end_array().key("materials").begin_array();
  for (const auto& material : scene.materials) {
    out.begin_object().member("name", material.name);
    write_model(out, scene, material.model);
    if (const auto& use = texture_of(material.model)) write_texture_use(out, scene.textures, "texture", *use);
    write(out, scene.textures, material.detail);
    out.end_object();
  }
  out.end_array();
}

// The face property of the PLY indexes the list of materials that the mesh uses, which stands in the JSON by
// name.
void write_mesh(Writer& out, const Scene& scene, const Mesh& mesh, const std::filesystem::path& ply) {
  if (mesh.subdivision) {
    out.begin_object().member("name", mesh.name).key("subdivision");
    write_subdivision(out, *mesh.subdivision);
    out.member("material", material_at(scene, mesh.triangle_materials.front()).name).end_object();
    return;
  }
  Mesh copy = mesh;
  std::vector<int> used;
  for (int& material : copy.triangle_materials) {
    const auto found = std::find(used.begin(), used.end(), material);
    const auto slot = static_cast<int>(found - used.begin());
    if (found == used.end()) used.push_back(material);
    material = slot;
  }
  write_ply(copy, ply);
  std::vector<std::string> names;
  for (const int material : used) names.push_back(material_at(scene, material).name);
  out.begin_object()
      .member("name", mesh.name)
      .member("file", ply.filename().string())
      .member("materials", names);
  if (mesh.end) {
    copy.positions = mesh.end->positions;
    copy.normals = mesh.end->normals;
    const auto end_ply = ply.parent_path() / (ply.stem().string() + ".end.ply");
    write_ply(copy, end_ply);
    out.key("end").begin_object().member("file", end_ply.filename().string()).end_object();
  }
  out.end_object();
}

void write_instance(Writer& out, const Scene& scene, const Instance& instance) {
  out.begin_object().member("name", instance.name);
  out.member("mesh", mesh_of(scene, instance).name);
  out.key("matrix").numbers(instance.matrix.m);
  if (instance.end_matrix) out.key("end_matrix").numbers(instance.end_matrix->m);
  std::vector<std::string> remap;
  for (const auto& [from, to] : instance.remap)
    for (const int material : {from, to}) remap.push_back(material_at(scene, material).name);
  if (!remap.empty()) out.member("remap", remap);
  out.end_object();
}

void write_shapes(Writer& out, const Scene& scene) {
  if (scene.spheres.empty() && scene.shapes.empty()) return;
  out.key("shapes").begin_array();
  for (const auto& sphere : scene.spheres) {
    out.begin_object().member("type", "sphere").member("name", sphere.name);
    out.member("centre", sphere.centre_m).member("radius", sphere.radius_m);
    out.member("material", material_at(scene, sphere.material).name).end_object();
  }
  for (const auto& shape : scene.shapes) write_shape(out, scene.materials, shape);
  out.end_array();
}

void write_settings(Writer& out, const Scene& scene) {
  out.key("integrator").begin_object();
  write_integrator(out, scene.integrator);
  if (!std::holds_alternative<AmbientOcclusion>(scene.integrator)) {
    out.key("trace_depth");
    if (scene.trace_depth == kUnlimitedDepth)
      out.value("unlimited");
    else
      out.value(scene.trace_depth);
  }
  out.end_object();
  if (scene.outputs == Outputs{}) return;
  const auto& [stokes, path_classes, layers] = scene.outputs;
  out.key("outputs").begin_object();
  out.member("stokes", stokes).member("path_classes", path_classes);
  if (!layers.empty()) {
    out.key("layers").begin_array();
    for (const auto& layer : layers) out.value(layer);
    out.end_array();
  }
  out.end_object();
}

}  // namespace

void write_scene(const Scene& scene, const std::filesystem::path& file, bool says_calls) {
  Writer out;
  out.begin_object().member("format", "orbs-scene/1").member("name", scene.name);
  if (says_calls) {
    out.key("calls_for").begin_array();
    for (const auto& one : light_switches(scene)) out.value(one.word);
    out.end_array();
  }
  write_camera(out, scene.camera);
  write_spectra(out, scene.spectra);
  write_environment(out, scene.spectra, scene.textures, scene.environment);
  write_materials(out, scene);
  out.key("meshes").begin_array();
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    write_mesh(out, scene, scene.meshes[i],
               file.parent_path() / fmt::format("{}.{}.ply", file.stem().string(), i));
  out.end_array().key("instances").begin_array();
  for (const auto& instance : scene.instances) write_instance(out, scene, instance);
  out.end_array();
  write_shapes(out, scene);
  out.key("lights").begin_array();
  for (const auto& light : scene.lights) write_light(out, scene.spectra, light);
  out.end_array();
  write_settings(out, scene);
  out.end_object();
  write_file(file, out.text());
}

}  // namespace orbs::scene
