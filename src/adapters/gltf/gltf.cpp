#include "adapters/gltf/gltf.h"

#include "adapters/format_limits.h"
#include "adapters/gltf/document.h"
#include "adapters/gltf/glb.h"
#include "adapters/gltf/textures.h"
#include "adapters/gltf/vertices.h"
#include "adapters/light_frame.h"
#include "adapters/lights_as_meshes.h"
#include "adapters/material_meshes.h"
#include "base/files.h"
#include "base/nth.h"
#include "scene/geometry/world_bounds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

using gltf::Document;

// Near planes clip, those of ORB.S do not: a millionth of the distance to the farthest point, the resolution
// of float coordinates there.
double near_m(double reach_m) { return 1e-6 * reach_m; }

// No point is farther from the camera.
double reach_m(const scene::Scene& scene) {
  const auto bounds = rough_bounds(scene);
  if (!bounds) return 1;
  const Vec3d eye = scene.camera.position_m;
  return std::max(1.0, 2 * radius_of(joined(*bounds, {eye, eye})));
}

// The texture's place in the file, to which it is added when it is not there.
int texture_place(Document& document, const scene::Scene& scene, int texture, std::map<int, int>& places) {
  const auto [place, is_new] = places.try_emplace(texture, static_cast<int>(document.textures.size()));
  const scene::Texture& given = nth(scene.textures, texture);
  if (is_new)
    document.textures.push_back({given.name, add_file(document.buffer, gltf::texture_png(given)),
                                 given.wrap_u, given.wrap_v, given.filter});
  return place->second;
}

// Each material that is shown, with its textures; the indices of the scene's materials go to those of the
// file.
std::map<int, int> add_materials(Document& document,
                                 const scene::Scene& scene,
                                 const std::map<int, gltf::TextureTransforms>& taken) {
  std::map<int, int> textures;
  std::map<int, int> places;
  for (const int index : scene::visible_materials(scene)) {
    const scene::Material& material = material_at(scene, index);
    const auto found = taken.find(index);
    const auto transforms = found == taken.end() ? gltf::TextureTransforms{} : found->second;
    gltf::Material written{material.name, gltf::surface_of(material), {}, {}};
    if (const auto& use = scene::texture_of(material.model))
      written.texture = {texture_place(document, scene, use->texture, textures), use->uv_set,
                         transforms.colour};
    if (const auto& map = material.detail.normal_map)
      written.normals = {{texture_place(document, scene, map->texture.texture, textures), map->texture.uv_set,
                          transforms.normals},
                         map->strength};
    places[index] = static_cast<int>(document.materials.size());
    document.materials.push_back(std::move(written));
  }
  return places;
}

// glTF numbers the sets without gaps.
std::vector<int> add_uv_sets(Document& document,
                             const gltf::Vertices& vertices,
                             const gltf::Material& shown) {
  const int colour_set = shown.texture ? shown.texture->uv_set : -1;
  const int normal_set = shown.normals ? shown.normals->info.uv_set : -1;
  std::vector<int> sets;
  if (std::max(colour_set, normal_set) >= 0) sets.push_back(add_uvs(document.buffer, vertices.uvs));
  if (std::max(colour_set, normal_set) == 1) sets.push_back(add_uvs(document.buffer, vertices.second_uvs));
  return sets;
}

int add_mesh(Document& document, const scene::Mesh& mesh, int material) {
  const gltf::Material& shown = nth(document.materials, material);
  const gltf::Vertices vertices = shown.normals
                                      ? gltf::vertices_with_tangents(mesh, shown.normals->info.uv_set)
                                      : gltf::vertices_of(mesh);
  gltf::Mesh written{.name = mesh.name, .material = material};
  written.positions = add_positions(document.buffer, vertices.positions);
  written.normals = add_normals(document.buffer, vertices.normals);
  if (shown.normals) written.tangents = add_tangents(document.buffer, vertices.tangents);
  written.uvs = add_uv_sets(document, vertices, shown);
  written.triangles = add_triangles(document.buffer, vertices.triangles);
  document.meshes.push_back(std::move(written));
  return static_cast<int>(document.meshes.size()) - 1;
}

// A node that stretches its axes unlike leaves open whether normals are turned before or after, so that a
// mesh with a normal map is stretched in the file.
bool may_share(const gltf::Placement& placement, const gltf::Material& material) {
  if (!material.normals) return true;
  // What lengths of turned axes lose by rounding.
  constexpr double kRounding = 1e-12;
  const auto [x, y, z] = placement.scale;
  const double size = std::abs(x);
  return std::abs(std::abs(y) - size) <= kRounding * size && std::abs(std::abs(z) - size) <= kRounding * size;
}

// All instances whose axes are at right angles share one mesh; each other one gets its own, which holds all
// of the matrix but the translation.
void add_nodes(Document& document, const MaterialMesh& shown, int material) {
  std::optional<int> shared;
  for (const Mat4& place : shown.places) {
    const auto placement = gltf::placement_of(place);
    if (placement && may_share(*placement, nth(document.materials, material))) {
      if (!shared) shared = add_mesh(document, shown.mesh, material);
      document.nodes.push_back({shown.mesh.name, *placement, *shared});
      continue;
    }
    const int own = add_mesh(document, gltf::sheared(shown.mesh, place), material);
    document.nodes.push_back({shown.mesh.name, {.translation = transform_point(place, {})}, own});
  }
}

// Only a turn and a place: its scale does nothing. It shines along -Z.
Mat4 light_place(const scene::Light& light) {
  const Vec3d z = -shining_direction(light.matrix);
  const Vec3d x = normalised(cross(std::abs(z.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, z));
  const Vec3d y = cross(z, x);
  const Vec3d o = transform_point(light.matrix, {});
  return {{x.x, y.x, z.x, o.x, x.y, y.y, z.y, o.y, x.z, y.z, z.z, o.z, 0, 0, 0, 1}};
}

void add_lights(Document& document, const std::vector<scene::Light>& lights) {
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const scene::Light& light = lights[i];
    const double largest = largest_magnitude(light.radiance);
    document.lights.push_back({.name = scene::display_name("light", light.name, i),
                               .type = type_name(light.shape),
                               .colour = largest > 0 ? light.radiance / largest : scene::RgbColour{},
                               .intensity = largest,
                               .placement = gltf::placement_of(light_place(light)).value()});
  }
}

Document document_of(const scene::Scene& scene) {
  scene::Scene shown = lights_as_meshes(scene);
  const auto transforms = gltf::take_texture_transforms(shown);
  const double reach = reach_m(shown);
  Document document{.name = scene.name,
                    .camera = scene.camera,
                    .near_m = near_m(reach),
                    .far_m = reach,
                    .trace_depth = scene.trace_depth};
  const auto materials = add_materials(document, shown, transforms);
  for (const MaterialMesh& mesh : material_meshes(shown, UvSets::Both))
    add_nodes(document, mesh, materials.at(mesh.material));
  add_lights(document, shown.lights);
  return document;
}

}  // namespace

void write_gltf(const scene::Scene& scene, const std::filesystem::path& file) {
  const Document document = document_of(scene);
  write_file(file, gltf::glb(gltf::json_text(document), document.buffer.bytes));
}

Exporter gltf_exporter() {
  return {.format = "gltf",
          .scene_file = "scene.glb",
          .settings = {},
          .limits = [](const scene::Scene& scene, const SceneSettings&) { return gltf_limits(scene); },
          .write = [](const scene::Scene& scene, const SceneSettings&,
                      const std::filesystem::path& file) { write_gltf(scene, file); }};
}

namespace {

std::string unsaid_of_light(const scene::Light& light, const std::string& display_name) {
  if (light.ies)
    return display_name + " has an IES profile: glTF has no light with a measured intensity distribution";
  if (light.reflectance != scene::RgbColour{})
    return display_name + " reflects where it shines: the exporter to glTF writes surfaces that shine alone";
  return "";
}

}  // namespace

namespace {

std::string tangents_limit(const scene::Scene& scene, const MaterialMesh& shown) {
  const scene::Material& material = material_at(scene, shown.material);
  const auto& map = material.detail.normal_map;
  if (!map || gltf::has_tangents(shown.mesh, map->texture.uv_set)) return "";
  return fmt::format(
      "mesh '{}' has a triangle whose texture coordinates lie on one line below the normal map of '{}': "
      "glTF must have tangents there",
      shown.mesh.name, material.name);
}

}  // namespace

std::vector<std::string> gltf_limits(const scene::Scene& scene) {
  std::vector<std::string> reasons = beyond_orbs_limits(scene, "glTF", gltf::beyond_orbs());
  const auto note = [&](const std::string& reason) {
    if (!reason.empty()) reasons.push_back(reason);
  };
  std::set<int> colours;
  std::set<int> normals;
  for (const int index : scene::visible_materials(scene)) {
    const scene::Material& material = material_at(scene, index);
    note(gltf::material_limit(material));
    note(gltf::texture_matrices_limit(scene, index));
    if (const auto& use = scene::texture_of(material.model)) colours.insert(use->texture);
    if (const auto& map = material.detail.normal_map) normals.insert(map->texture.texture);
  }
  for (const int index : colours)
    note(gltf::texture_limit(nth(scene.textures, index), gltf::TexelsOf::Colours));
  for (const int index : normals)
    note(gltf::texture_limit(nth(scene.textures, index), gltf::TexelsOf::Numbers));
  if (!normals.empty())
    for (const MaterialMesh& shown : material_meshes(scene, UvSets::Both)) note(tangents_limit(scene, shown));
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    note(unsaid_of_light(scene.lights[i], scene::display_name("light", scene.lights[i].name, i)));
  return reasons;
}

}  // namespace orbs::adapters
