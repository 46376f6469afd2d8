#include "importer/meshes.h"

#include "importer/gltf_material.h"
#include "importer/materials.h"
#include "importer/textures.h"
#include "scene/geometry/uv_frames.h"

#include <algorithm>
#include <cmath>

namespace orbs::importer {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

Vec3d geometric_normal(const std::vector<Vec3d>& positions, const Triangle& t) {
  return cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
}

// 3.7.2.1 of the specification: without normals, those of the flat triangles. Those without an area have
// none, and nothing of them is seen.
void make_flat(Vertices& vertices, std::vector<Triangle>& triangles) {
  Vertices flat;
  std::vector<Triangle> kept;
  for (const Triangle& triangle : triangles) {
    const Vec3d normal = geometric_normal(vertices.positions, triangle);
    if (normal == Vec3d{} || !is_finite(normal)) continue;
    const auto first = static_cast<std::uint32_t>(flat.positions.size());
    for (const auto corner : triangle) {
      flat.positions.push_back(vertices.positions[corner]);
      flat.normals.push_back(normalised(normal));
      flat.tangents.push_back(vertices.tangents[corner]);
      flat.uvs.push_back(vertices.uvs[corner]);
      flat.map_uvs.push_back(vertices.map_uvs[corner]);
      if (!vertices.second_uvs.empty()) flat.second_uvs.push_back(vertices.second_uvs[corner]);
    }
    kept.push_back({first, first + 1, first + 2});
  }
  vertices = std::move(flat);
  triangles = std::move(kept);
}

// Whether all could be used as given.
bool mend_normals(Vertices& vertices, const std::vector<Triangle>& triangles) {
  const auto is_good = [](Vec3d normal) { return scene::is_direction(cast<float>(normal)); };
  std::vector<Vec3d> around(vertices.positions.size());
  bool is_mended = false;
  for (const Triangle& triangle : triangles)
    for (const auto corner : triangle)
      if (!is_good(vertices.normals[corner]))
        around[corner] += geometric_normal(vertices.positions, triangle);
  for (std::size_t i = 0; i < around.size(); ++i) {
    if (is_good(vertices.normals[i])) continue;
    const double size = length(around[i]);
    vertices.normals[i] = size > 0 && std::isfinite(size) ? around[i] / size : Vec3d{0, 1, 0};
    is_mended = true;
  }
  return !is_mended;
}

// Some files hold the mesh unpacked, too.
bool is_packed(const Source& source, const tinygltf::Primitive& primitive) {
  const int positions = primitive.attributes.at("POSITION");
  return item(source, source.model.accessors, positions, "accessor", "a mesh").bufferView < 0;
}

// Of the vertices that have colours; white if they have none. All alike: that colour, and nothing is lost.
scene::RgbColour mean_colour(Import& import, const tinygltf::Primitive& primitive, const std::string& where) {
  const auto found = primitive.attributes.find("COLOR_0");
  if (found == primitive.attributes.end()) return {1, 1, 1};
  const auto colours = read_numbers(import.source, found->second, 0, "COLOR_0 of " + where);
  if (colours.count == 0 || colours.width < 3) return {1, 1, 1};
  scene::RgbColour sum;
  bool is_even = true;
  for (std::size_t i = 0; i < colours.count; ++i) {
    const double* c = colours.element(i);
    sum += Vec3d{c[0], c[1], c[2]};
    is_even = is_even && std::equal(c, c + 3, colours.element(0));
  }
  if (!is_finite(sum)) refuse(import.source, "COLOR_0 of " + where + " holds numbers that are not finite");
  const double* first = colours.element(0);
  if (is_even) return {first[0], first[1], first[2]};
  import.report.not_understood("colours of vertices", "their mean over a part of a mesh", where);
  return sum / static_cast<double>(colours.count);
}

// Whether the tangents of the last vertices are those of the triangles' coordinates, as ours are. A
// difference below this turns normals by no more.
bool follow_coordinates(const scene::Mesh& mesh,
                        std::size_t first_triangle,
                        std::size_t first_vertex,
                        const std::vector<double>& sides,
                        int uv_set) {
  constexpr double kMost_rad = 1e-3;
  for (std::size_t i = first_triangle; i < mesh.triangles.size(); ++i) {
    const auto frame = scene::uv_frame(mesh, i, uv_set);
    if (!frame) continue;
    for (const auto corner : mesh.triangles[i]) {
      const auto ours = tangent_across(*frame, normalised(cast<double>(mesh.normals[corner])));
      if (!ours) continue;
      const bool has_other_side = (sides[corner - first_vertex] < 0) != scene::is_mirrored(*frame);
      if (has_other_side || !(length(cast<double>(mesh.tangents[corner]) - *ours) <= kMost_rad)) return false;
    }
  }
  return true;
}

// 3.7.2.1 of the specification: those of a primitive without normals are to be ignored.
void name_tangents(Import& import,
                   const tinygltf::Primitive& primitive,
                   const std::string& where,
                   const Vertices& vertices,
                   const scene::Mesh& mesh,
                   std::size_t first_triangle) {
  if (material_at(import, primitive.material).normalTexture.index < 0 ||
      !primitive.attributes.contains("NORMAL") || !primitive.attributes.contains("TANGENT"))
    return;
  const std::size_t first_vertex = mesh.positions.size() - vertices.positions.size();
  const int uv_set = second_coordinates(import, primitive.material) ? 1 : 0;
  if (!follow_coordinates(mesh, first_triangle, first_vertex, vertices.tangent_sides, uv_set))
    import.report.not_understood("tangents under normal maps",
                                 "those of the texture coordinates of each triangle", where);
}

// Without coordinates a texture would show its corner everywhere.
void name_absent_coordinates(Import& import, const tinygltf::Primitive& primitive, const std::string& where) {
  const auto& material = material_at(import, primitive.material);
  const auto& pbr = material.pbrMetallicRoughness;
  for (const auto& info : {pbr.baseColorTexture, pbr.metallicRoughnessTexture, material.emissiveTexture,
                           normal_info(material)}) {
    if (info.index < 0) continue;
    const auto name = fmt::format("TEXCOORD_{}", coordinate_set(info));
    if (!primitive.attributes.contains(name))
      import.report.not_understood(fmt::format("textures of meshes without their coordinates ({})", name),
                                   "the texel at (0, 0) everywhere", where);
  }
}

}  // namespace

const std::optional<SurfaceMap>& Meshes::surface_map(int material) {
  const auto [known, is_new] = surface_maps_.try_emplace(material);
  if (is_new) known->second = SurfaceMap::of(*import_, material);
  return known->second;
}

// For the triangles of the mesh that have none yet. `map_uvs`: of its last vertices.
void Meshes::add_materials(const tinygltf::Primitive& primitive,
                           const std::string& where,
                           const std::vector<Vec2f>& map_uvs,
                           scene::Mesh& mesh) {
  const std::size_t first_triangle = mesh.triangle_materials.size();
  const std::size_t first_vertex = mesh.positions.size() - map_uvs.size();
  const scene::RgbColour tint = mean_colour(*import_, primitive, where);
  const auto& map = surface_map(primitive.material);
  if (!map) {
    mesh.triangle_materials.resize(mesh.triangles.size(),
                                   material_for(*import_, primitive.material, {tint, 1, 1}));
    return;
  }
  for (std::size_t i = first_triangle; i < mesh.triangles.size(); ++i) {
    std::array<Vec2f, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = map_uvs[mesh.triangles[i][k] - first_vertex];
    mesh.triangle_materials.push_back(material_for(*import_, primitive.material, map->shown(corners, tint)));
  }
}

void Meshes::add_primitive(const tinygltf::Primitive& primitive,
                           const std::string& where,
                           const Pose& pose,
                           scene::Mesh& mesh) {
  const auto& source = import_->source;
  auto& report = import_->report;
  if (primitive.mode >= TINYGLTF_MODE_POINTS && primitive.mode < TINYGLTF_MODE_TRIANGLES) {
    report.not_understood("points and lines", "nothing", where);
    return;
  }
  if (!primitive.attributes.contains("POSITION")) {
    report.not_understood("meshes without positions", "nothing", where);
    return;
  }
  for (const auto& [name, value] : primitive.extensions) {
    if (name == "KHR_draco_mesh_compression" && is_packed(source, primitive))
      refuse(source, fmt::format("the triangles of {} {}", where, packed_text(name)));
    report.not_understood(name, "as if it were not there", where);
  }
  name_absent_coordinates(*import_, primitive, where);
  const int colour_set = colour_coordinates(*import_, primitive.material);
  const auto& map = surface_map(primitive.material);
  const UvSets sets{colour_set, map ? map->coordinates() : colour_set,
                    second_coordinates(*import_, primitive.material)};
  auto vertices = read_vertices(source, primitive, pose, sets, where);
  auto triangles = read_triangles(source, primitive, vertices.positions.size(), where);
  if (vertices.normals.empty())
    make_flat(vertices, triangles);
  else if (!mend_normals(vertices, triangles))
    report.not_understood("normals of length 0 or not finite", "those of the triangles around", where);
  if (triangles.size() > triangles_left_)
    refuse(source, fmt::format("{} has {} triangles: too many for a scene", where, triangles.size()));
  triangles_left_ -= triangles.size();
  const auto first_vertex = scene::vertex_count(mesh);
  for (std::size_t i = 0; i < vertices.positions.size(); ++i) {
    mesh.positions.push_back(cast<float>(vertices.positions[i]));
    mesh.normals.push_back(cast<float>(vertices.normals[i]));
    mesh.tangents.push_back(cast<float>(vertices.tangents[i]));
    mesh.uvs.push_back(vertices.uvs[i]);
  }
  if (!mesh.second_uvs.empty() || !vertices.second_uvs.empty()) {
    mesh.second_uvs.resize(first_vertex);
    mesh.second_uvs.insert(mesh.second_uvs.end(), vertices.second_uvs.begin(), vertices.second_uvs.end());
    mesh.second_uvs.resize(mesh.positions.size());
  }
  for (const Triangle& t : triangles)
    mesh.triangles.push_back({t[0] + first_vertex, t[1] + first_vertex, t[2] + first_vertex});
  name_tangents(*import_, primitive, where, vertices, mesh, mesh.triangles.size() - triangles.size());
  add_materials(primitive, where, vertices.map_uvs, mesh);
}

std::optional<int> Meshes::add(int index, const Pose& pose) {
  const bool is_resting = pose.joints.empty() && pose.weights.empty();
  if (const auto known = resting_.find(index); is_resting && known != resting_.end()) return known->second;
  const auto& wanted = item(import_->source, import_->source.model.meshes, index, "mesh", "a node");
  const auto where = place("mesh", wanted.name, static_cast<std::size_t>(index));
  scene::Mesh mesh;
  mesh.name = names_.add(wanted.name, fmt::format("mesh {}", index));
  for (const auto& primitive : wanted.primitives) add_primitive(primitive, where, pose, mesh);
  std::optional<int> added;
  if (!mesh.triangles.empty()) {
    added = static_cast<int>(import_->scene.meshes.size());
    import_->scene.meshes.push_back(std::move(mesh));
  }
  if (is_resting) resting_[index] = added;
  return added;
}

}  // namespace orbs::importer
