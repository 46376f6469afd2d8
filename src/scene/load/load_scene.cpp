#include "scene/load/load_scene.h"

#include "base/files.h"
#include "base/nth.h"
#include "base/text.h"
#include "image/layers.h"
#include "scene/effects/effects.h"
#include "scene/load/camera.h"
#include "scene/load/detail_checks.h"
#include "scene/load/instance.h"
#include "scene/load/mesh.h"
#include "scene/load/spectra.h"
#include "scene/load/texture_checks.h"
#include "scene/motion.h"
#include "scene/scene.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::scene {

namespace {

// Below this sine the projected axis is nothing but the rounding of the vertices' floats.
constexpr double kLeastSine = 1e-4;

std::string axis_problem_of_meshes(const Scene& scene, Vec3d axis, int material) {
  for (const auto& instance : scene.instances) {
    const auto& mesh = mesh_of(scene, instance);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (remapped(instance, mesh.triangle_materials[i]) != material) continue;
      const auto corner = [&](std::size_t k) {
        return transform_point(instance.matrix, cast<double>(mesh.positions[mesh.triangles[i][k]]));
      };
      const Vec3d normal = cross(corner(1) - corner(0), corner(2) - corner(0));
      if (length(normal) == 0 || length(cross(normal, axis)) > kLeastSine * length(normal) * length(axis))
        continue;
      return fmt::format("the axis ({}, {}, {}) stands perpendicular to triangle {} of instance '{}'", axis.x,
                         axis.y, axis.z, i, instance.name);
    }
  }
  return "";
}

std::string axis_problem(const Scene& scene, Vec3d axis, int material) {
  auto problem = axis_problem_of_meshes(scene, axis, material);
  // Surfaces that are right at both ends of the frame may be wrong for no more than an instant between.
  if (has_moving_objects(scene))
    for (const double time : {scene.camera.shutter.open, scene.camera.shutter.close})
      if (problem.empty()) problem = axis_problem_of_meshes(at_time(scene, time), axis, material);
  if (!problem.empty()) return problem;
  for (std::size_t i = 0; i < scene.spheres.size(); ++i)
    if (scene.spheres[i].material == material)
      return fmt::format(
          "{} is a sphere and no thin optical element: an axis can be projected into flat surfaces only",
          display_name("shape", scene.spheres[i].name, i));
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    bool is_shown = false;
    for_each_leaf(scene.shapes[i], scene.shapes[i].material,
                  [&](const Shape&, int own) { is_shown = is_shown || own == material; });
    if (is_shown)
      return fmt::format(
          "{} is {} and no thin optical element: an axis can be projected into the flat surfaces of meshes only",
          display_name("shape", scene.shapes[i].name, scene.spheres.size() + i),
          what_is(scene.shapes[i].form));
  }
  return "";
}

// Thin optical elements (polarisers, retarders) project their axis into the surface that shows them. The
// complaint where that is impossible: the axis is perpendicular to a triangle, or the surface is a sphere.
// "" for a material without an axis, and where all is well.
std::string check_polariser_axis(const Scene& scene, int material) {
  return std::visit(
      [&](const auto& model) -> std::string {
        if constexpr (requires { model.axis; }) return axis_problem(scene, model.axis, material);
        return "";
      },
      material_at(scene, material).model);
}

Texture load_texture(json::ObjectReader in, const DataFolders& folders) {
  Texture texture;
  texture.name = in.text("name");
  texture.file = existing_file(in, "file", folders);
  const auto wrap = [&](const char* key) {
    const auto word = in.one_of_or(key, "repeat", {"repeat", "clamp", "mirror"});
    if (word == "mirror") return Wrap::Mirror;
    return word == "clamp" ? Wrap::Clamp : Wrap::Repeat;
  };
  texture.wrap_u = wrap("wrap_u");
  texture.wrap_v = wrap("wrap_v");
  if (in.one_of_or("filter", "linear", {"linear", "nearest"}) == "nearest") texture.filter = Filter::Nearest;
  if (in.one_of_or("encoding", "srgb", {"srgb", "linear"}) == "linear") texture.encoding = Encoding::Linear;
  in.finish();
  return texture;
}

void add_integrator(json::ObjectReader in, Scene& scene) {
  scene.integrator = load_integrator(in);
  if (std::holds_alternative<AmbientOcclusion>(scene.integrator)) {
    in.finish();
    return;
  }
  if (in.has("trace_depth") && in.holds_text("trace_depth")) {
    in.one_of("trace_depth", {"unlimited"});
    scene.trace_depth = kUnlimitedDepth;
  } else {
    scene.trace_depth = in.integer_or("trace_depth", scene.trace_depth, 1, 1000);
  }
  in.finish();
}

std::vector<std::string> load_layers(json::ObjectReader& in) {
  std::set<std::string> known;
  for (const auto& layer : image::kLayers) known.emplace(layer.name);
  std::vector<std::string> layers;
  for (auto& name : in.texts("layers")) {
    if (!known.contains(name))
      in.fail("layers", fmt::format("there is no layer '{}'{}; there are {}", name, closest(name, known),
                                    fmt::join(known, ", ")));
    if (std::find(layers.begin(), layers.end(), name) != layers.end())
      in.fail("layers", fmt::format("layer '{}' is named twice", name));
    layers.push_back(std::move(name));
  }
  return layers;
}

// A spectrum has no three numbers until a light is known.
void check_layers(const Scene& scene, json::ObjectReader& in) {
  const auto& layers = scene.outputs.layers;
  const bool wants_albedo = std::find(layers.begin(), layers.end(), "albedo") != layers.end();
  if (wants_albedo && !scene.spectra.empty())
    in.fail("outputs",
            "the layer 'albedo' holds three channels, and the scene has spectra: leave out one of the two");
}

// What more than its colour the image holds; those of light need light paths.
Outputs load_outputs(json::ObjectReader in, const Integrator& integrator) {
  Outputs outputs{in.boolean_or("stokes", false), in.boolean_or("path_classes", false)};
  const auto no_paths = no_paths_reason(integrator);
  for (const char* key : {"stokes", "path_classes"})
    if (!no_paths.empty() && in.boolean_or(key, false)) in.fail(key, no_paths);
  if (in.has("layers")) outputs.layers = load_layers(in);
  in.finish();
  return outputs;
}

// Checks that need the whole scene; `readers` are those of the materials.
void check_materials(const Scene& scene, const std::vector<json::ObjectReader>& readers) {
  for (std::size_t i = 0; i < readers.size(); ++i)
    if (const auto problem = check_polariser_axis(scene, static_cast<int>(i)); !problem.empty())
      readers[i].fail("", problem);
  std::string key;
  for (std::size_t i = 0; i < readers.size(); ++i)
    if (const auto problem = detail_problem(scene, static_cast<int>(i), key); !problem.empty())
      readers[i].fail(key, problem);
  for (std::size_t i = 0; i < readers.size(); ++i)
    if (const auto problem = uv_set_problem(scene, static_cast<int>(i)); !problem.empty())
      readers[i].fail("", problem);
}

void check_textures(const Scene& scene, const std::vector<json::ObjectReader>& readers) {
  for (std::size_t i = 0; i < readers.size(); ++i)
    if (const auto problem = texture_problem(scene, i); !problem.empty()) readers[i].fail("file", problem);
}

void check_irradiance_cache(const Scene& scene, const json::ObjectReader& in) {
  if (!std::holds_alternative<IrradianceCache>(scene.integrator)) return;
  if (has_motion(scene))
    in.fail("integrator",
            "an irradiance cache is made at one time, and something moves while the shutter is open: use the "
            "integrator 'path'");
  const auto found = effects(scene);
  if (const auto needed = transport(found); needed != LightTransport::Rgb)
    in.fail("integrator", fmt::format("an irradiance cache keeps three channels, and the scene calls for {} "
                                      "transport{}: use the integrator 'path'",
                                      transport_name(needed), reason_for(found)));
}

// A sphere without a matrix is kept as one.
void add_shape(json::ObjectReader& in, const Names& materials, Scene& scene) {
  const bool has_matrix = in.has("matrix");
  Shape shape = load_shape(in, materials);
  const auto* sphere = std::get_if<SphereForm>(&shape.form);
  if (sphere != nullptr && !has_matrix)
    scene.spheres.push_back({shape.name, sphere->centre_m, sphere->radius_m, shape.material});
  else
    scene.shapes.push_back(std::move(shape));
}

// Meshes whose vertices are relative to an origin get it back by the matrices of their instances, in double.
void move_to_origins(const std::vector<Vec3d>& origins, std::vector<Instance>& instances) {
  for (auto& instance : instances) {
    const Vec3d origin = nth(origins, instance.mesh);
    if (origin == Vec3d{}) continue;
    instance.matrix = instance.matrix * translation(origin);
    if (instance.end_matrix) instance.end_matrix = *instance.end_matrix * translation(origin);
  }
}

void append(std::vector<std::string>& all, const std::vector<std::string>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

Scene load_document(const json::Document& document,
                    const DataFolders& folders,
                    SceneBudget left,
                    const std::string& camera) {
  json::ObjectReader in(document);
  in.one_of("format", {"orbs-scene/1"});
  Scene scene;
  scene.name = in.text("name");
  // For renderers; it follows from the rest, so nothing is made of it here.
  if (in.has("calls_for")) in.texts("calls_for");
  scene.camera = load_cameras(in, camera);
  SpectralData data{.folders = folders};
  for (auto& entry : in.objects_or_none("spectra")) load_spectrum(entry, data);
  Names textures("texture");
  auto texture_readers = in.objects_or_none("textures");
  for (auto& entry : texture_readers) {
    textures.add(entry, "name");
    scene.textures.push_back(load_texture(entry, folders));
  }
  scene.environment = load_environment(in, textures, data);
  Names materials("material");
  auto material_readers = in.objects("materials");
  for (auto& entry : material_readers) {
    materials.add(entry, "name");
    scene.materials.push_back(load_material(entry, textures, data, materials, scene.materials));
  }
  Names meshes("mesh");
  std::vector<Vec3d> origins;
  std::vector<std::string> mesh_places;
  for (auto& entry : in.objects_or_none("meshes")) {
    meshes.add(entry, "name");
    auto file = load_mesh(entry, folders, materials, left);
    scene.meshes.push_back(std::move(file.mesh));
    origins.push_back(file.origin_m);
    mesh_places.push_back(entry.place("name"));
    append(data.warnings, file.warnings);
  }
  for (auto& entry : in.objects_or_none("instances"))
    load_instances(entry, meshes, materials, left, scene.instances);
  move_to_origins(origins, scene.instances);
  for (auto& entry : in.objects_or_none("shapes")) add_shape(entry, materials, scene);
  for (auto& entry : in.objects_or_none("lights")) scene.lights.push_back(load_light(entry, folders, data));
  if (in.has("integrator")) add_integrator(in.object("integrator"), scene);
  if (in.has("outputs")) scene.outputs = load_outputs(in.object("outputs"), scene.integrator);
  in.finish();
  append(data.warnings, flat_texture_warnings(scene, mesh_places));
  scene.spectra = std::move(data.spectra);
  scene.notes = {std::move(data.files), std::move(data.warnings), camera};
  check_layers(scene, in);
  drop_unseen_motion(scene);
  check_textures(scene, texture_readers);
  check_materials(scene, material_readers);
  check_irradiance_cache(scene, in);
  return scene;
}

}  // namespace

Scene load_scene_text(const std::string& name,
                      const std::string& text,
                      const std::filesystem::path& folder,
                      SceneBudget budget,
                      const std::string& camera) {
  const auto document = json::parse(name, text);
  return load_document(document, {folder}, budget, camera);
}

Scene load_scene(const std::filesystem::path& file,
                 const std::vector<std::filesystem::path>& data_folders,
                 const std::string& camera) {
  const auto document = json::parse(file.string(), read_file(file));
  return load_document(document, {std::filesystem::absolute(file).parent_path(), data_folders}, {}, camera);
}

}  // namespace orbs::scene
