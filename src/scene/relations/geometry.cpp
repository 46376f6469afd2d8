#include "scene/relations/geometry.h"

#include "scene/camera_frame.h"
#include "scene/geometry/generators.h"
#include "scene/geometry/world_bounds.h"
#include "scene/relations/light.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace orbs::scene {

double rescaling_into(const Scene& scene, double least_radius_m, double most_radius_m) {
  assert(most_radius_m >= 2 * least_radius_m && "else no power of two may lead there");
  const auto drawn = rough_bounds(scene);
  if (!drawn) return 1;
  const Vec3d eye = scene.camera.position_m;
  const double radius = radius_of(joined(*drawn, {eye, eye}));
  if (!(radius > 0)) return 1;
  if (radius < least_radius_m) return std::exp2(std::ceil(std::log2(least_radius_m / radius)));
  if (radius > most_radius_m) return std::exp2(std::floor(std::log2(most_radius_m / radius)));
  return 1;
}

namespace {

bool shows_emission(const Scene& scene, int mesh) {
  const auto emits = [&](int material) {
    return std::holds_alternative<Emission>(material_at(scene, material).model);
  };
  for (const auto& instance : scene.instances)
    if (instance.mesh == mesh)
      for (const int material : mesh_of(scene, instance).triangle_materials)
        if (emits(remapped(instance, material))) return true;
  return false;
}

bool is_flat(const Mesh& mesh) {
  const auto are_equal = [](const std::vector<Vec3f>& normals, const auto& t) {
    return normals[t[0]] == normals[t[1]] && normals[t[0]] == normals[t[2]];
  };
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
    return are_equal(mesh.normals, t) && (!mesh.end || are_equal(mesh.end->normals, t));
  });
}

// Places the middle of edges, each once for the two triangles beside it.
class Middles {
 public:
  explicit Middles(Mesh& mesh) : mesh_(mesh) {}

  std::uint32_t of(std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto [found, is_new] = places_.try_emplace(std::minmax(a, b), next);
    if (is_new) {
      const auto half = [](auto x, auto y) { return (x + y) * 0.5F; };
      mesh_.positions.push_back(half(mesh_.positions[a], mesh_.positions[b]));
      mesh_.normals.push_back(mesh_.normals[a]);
      if (mesh_.end) {
        mesh_.end->positions.push_back(half(mesh_.end->positions[a], mesh_.end->positions[b]));
        mesh_.end->normals.push_back(mesh_.end->normals[a]);
      }
      mesh_.tangents.push_back(half(mesh_.tangents[a], mesh_.tangents[b]));
      append_middle(mesh_.uvs, a, b);
      if (!mesh_.second_uvs.empty()) append_middle(mesh_.second_uvs, a, b);
    }
    return found->second;
  }

 private:
  static void append_middle(std::vector<Vec2f>& uvs, std::uint32_t a, std::uint32_t b) {
    uvs.push_back({0.5F * (uvs[a].x + uvs[b].x), 0.5F * (uvs[a].y + uvs[b].y)});
  }

  Mesh& mesh_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> places_;
};

void split(Mesh& mesh) {
  mesh.subdivision.reset();
  Middles middles(mesh);
  const auto triangles = std::exchange(mesh.triangles, {});
  const auto materials = std::exchange(mesh.triangle_materials, {});
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto [a, b, c] = triangles[i];
    const auto ab = middles.of(a, b);
    const auto bc = middles.of(b, c);
    const auto ca = middles.of(c, a);
    mesh.triangles.insert(mesh.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    mesh.triangle_materials.insert(mesh.triangle_materials.end(), 4, materials[i]);
  }
}

// True if a mesh was split.
bool split_meshes(Scene& scene, bool with_emission) {
  bool is_any = false;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (shows_emission(scene, static_cast<int>(i)) != with_emission || !is_flat(scene.meshes[i])) continue;
    split(scene.meshes[i]);
    is_any = true;
  }
  return is_any;
}

bool is_opaque_and_two_sided(const MaterialModel& model) {
  return std::holds_alternative<Lambert>(model) || std::holds_alternative<OrenNayar>(model) ||
         std::holds_alternative<Mirror>(model) || std::holds_alternative<Ggx>(model) ||
         std::holds_alternative<Emission>(model);
}

// Turned normals are those of the side that the vertex normals point to, so they would be turned otherwise.
bool may_flip_normals(const Scene& scene, std::size_t mesh) {
  for (const auto& instance : scene.instances)
    if (instance.mesh == static_cast<int>(mesh))
      for (const int material : scene.meshes[mesh].triangle_materials)
        if (const auto& shown = material_at(scene, remapped(instance, material));
            !is_opaque_and_two_sided(shown.model) || turns_normals(shown.detail))
          return false;
  return true;
}

}  // namespace

Scene with_triangles_reversed(const Scene& scene) {
  Scene out = scene;
  for (auto& mesh : out.meshes) {
    mesh.subdivision.reset();
    std::reverse(mesh.triangles.begin(), mesh.triangles.end());
    std::reverse(mesh.triangle_materials.begin(), mesh.triangle_materials.end());
  }
  return out;
}

Scene with_objects_reversed(const Scene& scene) {
  Scene out = scene;
  std::reverse(out.instances.begin(), out.instances.end());
  std::reverse(out.spheres.begin(), out.spheres.end());
  std::reverse(out.shapes.begin(), out.shapes.end());
  return out;
}

Scene with_lights_reversed(const Scene& scene) {
  Scene out = scene;
  std::reverse(out.lights.begin(), out.lights.end());
  return out;
}

std::variant<Scene, std::string> with_triangles_split(const Scene& scene) {
  Scene out = scene;
  if (!split_meshes(out, false)) return "it has no mesh with flat normals";
  return out;
}

std::variant<Scene, std::string> with_emitters_split(const Scene& scene) {
  Scene out = scene;
  bool is_any = split_meshes(out, true);
  out.lights.clear();
  for (const auto& light : scene.lights) {
    const auto* rect = std::get_if<RectShape>(&light.shape);
    if (!has_area(light.shape)) {
      is_any = true;
      for (const char* half : {"first", "second"}) {
        out.lights.push_back(light);
        out.lights.back().name = fmt::format("{} {} half", light.name, half);
        multiply_emission(out.lights.back(), 0.5);
      }
      continue;
    }
    if (rect == nullptr || light.ies) {
      out.lights.push_back(light);
      continue;
    }
    is_any = true;
    for (const double x : {-0.5, 0.5})
      for (const double z : {-0.5, 0.5}) {
        Light quarter = light;
        quarter.name = fmt::format("{} quarter {} {}", light.name, x, z);
        quarter.shape = RectShape{rect->half_width_m / 2, rect->half_length_m / 2};
        quarter.matrix = light.matrix * translation({x * rect->half_width_m, 0, z * rect->half_length_m});
        out.lights.push_back(std::move(quarter));
      }
  }
  if (!is_any) return "it has no flat mesh with emission, no rectangular light and none without an area";
  return out;
}

Scene with_windings_flipped(const Scene& scene) {
  Scene out = scene;
  for (std::size_t i = 0; i < out.meshes.size(); ++i) {
    out.meshes[i].subdivision.reset();
    for (auto& triangle : out.meshes[i].triangles) std::swap(triangle[1], triangle[2]);
    if (!may_flip_normals(scene, i)) continue;
    for (Vec3f& normal : out.meshes[i].normals) normal = -normal;
    if (!out.meshes[i].end) continue;
    for (Vec3f& normal : out.meshes[i].end->normals) normal = -normal;
  }
  return out;
}

std::variant<Scene, std::string> with_unreachable_object(const Scene& scene) {
  if (shines(scene.environment)) return "its environment shines, so every place is reached by light";
  if (std::holds_alternative<LatitudeLongitude>(scene.camera.projection))
    return "its camera sees all directions";
  const auto bounds = world_bounds(scene);
  if (!bounds) return "it is empty";
  const Vec3d eye = scene.camera.position_m;
  const double farthest =
      std::fmax(length(bounds->low - eye), length(bounds->high - eye)) + length(bounds->high - bounds->low);
  Scene out = scene;
  out.materials.push_back({"unreachable black", Lambert{}});
  Mesh cube = make_cube({0.05 * farthest});
  cube.name = "unreachable cube";
  cube.triangle_materials.assign(cube.triangles.size(), static_cast<int>(out.materials.size()) - 1);
  out.meshes.push_back(std::move(cube));
  const Vec3d place = eye - camera_frame(scene.camera).forward * (3 * farthest);
  out.instances.push_back(
      {"unreachable cube", static_cast<int>(out.meshes.size()) - 1, translation(place), {}});
  return out;
}

}  // namespace orbs::scene
