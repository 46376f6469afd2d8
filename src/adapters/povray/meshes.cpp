#include "adapters/povray/meshes.h"

#include "adapters/mirrored_image.h"
#include "adapters/povray/clamp.h"
#include "adapters/povray/materials.h"
#include "adapters/povray/sdl.h"
#include "base/nth.h"

#include <algorithm>
#include <iterator>
#include <set>

#include <fmt/format.h>

namespace orbs::adapters::povray {

namespace {

using scene::Mesh;
using scene::TextureUse;

struct Vertex {
  Vec3f position;
  Vec3f normal;
  Vec2f uv;
};

/// Content of one mesh2: one index serves position, normal and texture coordinates.
struct Mesh2 {
  std::vector<Vertex> vertices;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> triangle_materials;
};

Vec2d looked_up_at(const scene::Scene& scene, Vec2f uv, const std::optional<TextureUse>& use) {
  const Vec2d given{uv.x, uv.y};
  if (!use) return given;
  const Mat4& m = use->matrix;
  const Vec2d scale = unmirrored_uv_scale(texture_at(scene, *use));
  return {scale.x * (m(0, 0) * given.x + m(0, 1) * given.y + m(0, 3)),
          scale.y * (m(1, 0) * given.x + m(1, 1) * given.y + m(1, 3))};
}

Corner corner_of(const scene::Scene& scene,
                 const Mesh& mesh,
                 std::uint32_t vertex,
                 const std::optional<TextureUse>& use) {
  return {cast<double>(mesh.positions[vertex]), cast<double>(mesh.normals[vertex]),
          looked_up_at(scene, (use && use->uv_set != 0 ? mesh.second_uvs : mesh.uvs)[vertex], use)};
}

Vertex vertex_of(const Corner& corner) {
  return {cast<float>(corner.position),
          cast<float>(corner.normal),
          {static_cast<float>(corner.uv.x), static_cast<float>(corner.uv.y)}};
}

// Builds a mesh2. POV-Ray refuses triangles without area with a warning each, so they are left out; they are
// invisible. Vertices are shared between triangles of one material, not across materials, whose texture
// matrices may differ.
class Mesh2Builder {
 public:
  Mesh2Builder(const scene::Scene& scene, const Mesh& mesh) : scene_(scene), mesh_(mesh) {}

  void add(const std::array<std::uint32_t, 3>& triangle, int material) {
    const auto& given = material_at(scene_, material);
    const auto& use = texture_of(given.model) ? texture_of(given.model) : given.detail.opacity_texture;
    const auto corner = [&](std::size_t i) { return corner_of(scene_, mesh_, triangle[i], use); };
    const std::array corners{corner(0), corner(1), corner(2)};
    if (!has_area(corners)) return;
    const auto axes = use ? clamp_axes_of(use->texture) : std::array<ClampAxis, 2>{};
    if (axes[0].active || axes[1].active) {
      for (const auto& piece : clamp_triangle(corners, axes)) add_piece(piece, material);
      return;
    }
    std::array<std::size_t, 3> indices{};
    for (std::size_t i = 0; i < 3; ++i) indices[i] = shared_vertex(triangle[i], material, corners[i]);
    result_.triangles.push_back(indices);
    result_.triangle_materials.push_back(material);
  }

  Mesh2 take() { return std::move(result_); }

 private:
  std::size_t shared_vertex(std::uint32_t vertex, int material, const Corner& corner) {
    const auto [place, is_new] = known_.try_emplace({material, vertex}, result_.vertices.size());
    if (is_new) result_.vertices.push_back(vertex_of(corner));
    return place->second;
  }

  void add_piece(const std::array<Corner, 3>& piece, int material) {
    const std::size_t first = result_.vertices.size();
    for (const Corner& corner : piece) result_.vertices.push_back(vertex_of(corner));
    result_.triangles.push_back({first, first + 1, first + 2});
    result_.triangle_materials.push_back(material);
  }

  const std::array<ClampAxis, 2>& clamp_axes_of(int texture) {
    const auto [place, is_new] = axes_.try_emplace(texture);
    if (is_new) place->second = clamp_axes(nth(scene_.textures, texture));
    return place->second;
  }

  const scene::Scene& scene_;
  const Mesh& mesh_;
  Mesh2 result_;
  std::map<std::pair<int, std::uint32_t>, std::size_t> known_;
  std::map<int, std::array<ClampAxis, 2>> axes_;
};

template <typename Items, typename Print>
void write_list(std::string& text, const char* name, const Items& items, const Print& print) {
  fmt::format_to(std::back_inserter(text), "  {} {{ {}", name, items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    text += i % 8 == 0 ? ",\n    " : ", ";
    print(items[i]);
  }
  text += "\n  }\n";
}

void write_mesh2(std::string& text, const std::string& name, const Mesh2& mesh) {
  auto out = std::back_inserter(text);
  fmt::format_to(out, "#declare {} = mesh2 {{\n", name);
  write_list(text, "vertex_vectors", mesh.vertices, [&](const Vertex& v) {
    fmt::format_to(out, "<{},{},{}>", v.position.x, v.position.y, v.position.z);
  });
  write_list(text, "normal_vectors", mesh.vertices,
             [&](const Vertex& v) { fmt::format_to(out, "<{},{},{}>", v.normal.x, v.normal.y, v.normal.z); });
  write_list(text, "uv_vectors", mesh.vertices,
             [&](const Vertex& v) { fmt::format_to(out, "<{},{}>", v.uv.x, v.uv.y); });
  const std::set<int> used(mesh.triangle_materials.begin(), mesh.triangle_materials.end());
  const std::vector<int> materials(used.begin(), used.end());
  write_list(text, "texture_list", materials,
             [&](int m) { fmt::format_to(out, "texture {{ Material{} }}", m); });
  const auto slot = [&](int m) {
    return std::lower_bound(materials.begin(), materials.end(), m) - materials.begin();
  };
  std::vector<std::size_t> order(mesh.triangles.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  write_list(text, "face_indices", order, [&](std::size_t i) {
    const auto& t = mesh.triangles[i];
    fmt::format_to(out, "<{},{},{}>,{}", t[0], t[1], t[2], slot(mesh.triangle_materials[i]));
  });
  text += "}\n";
}

std::vector<int> materials_after_remap(const Mesh& mesh, const scene::Instance& instance) {
  std::map<int, int> shown;
  std::vector<int> result;
  result.reserve(mesh.triangle_materials.size());
  for (const int material : mesh.triangle_materials) {
    const auto [place, is_new] = shown.try_emplace(material);
    if (is_new) place->second = scene::remapped(instance, material);
    result.push_back(place->second);
  }
  return result;
}

int part_of(const scene::Scene& scene, int material) {
  return is_photon_target(material_at(scene, material).model) ? material : -1;
}

std::vector<DeclaredMesh> declare_parts(const scene::Scene& scene,
                                        const Mesh& mesh,
                                        const std::vector<int>& materials,
                                        MeshLibrary& library) {
  std::map<int, Mesh2Builder> builders;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    builders.try_emplace(part_of(scene, materials[i]), scene, mesh)
        .first->second.add(mesh.triangles[i], materials[i]);
  std::vector<DeclaredMesh> parts;
  const std::size_t number = library.parts.size();
  for (auto& [material, builder] : builders) {
    const Mesh2 mesh2 = builder.take();
    if (mesh2.triangles.empty()) continue;
    const std::string suffix = material < 0 ? "" : fmt::format("Part{}", material);
    parts.push_back({fmt::format("Mesh{}{}", number, suffix), material});
    write_mesh2(library.text, parts.back().name, mesh2);
  }
  return parts;
}

}  // namespace

const std::vector<DeclaredMesh>& declared_meshes(const scene::Scene& scene,
                                                 const scene::Instance& instance,
                                                 MeshLibrary& library) {
  const Mesh& mesh = mesh_of(scene, instance);
  std::vector<int> materials = materials_after_remap(mesh, instance);
  // The key is short: only what each material of the mesh became.
  std::map<int, int> shown;
  for (std::size_t i = 0; i < materials.size(); ++i) shown.emplace(mesh.triangle_materials[i], materials[i]);
  std::vector<int> key;
  for (const auto& [given, seen] : shown) key.push_back(seen);
  const std::pair place{instance.mesh, key};
  if (const auto known = library.parts.find(place); known != library.parts.end()) return known->second;
  auto parts = declare_parts(scene, mesh, materials, library);
  return library.parts.emplace(place, std::move(parts)).first->second;
}

}  // namespace orbs::adapters::povray
