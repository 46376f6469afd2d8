#include "tracer/world/build_meshes.h"

#include "base/nth.h"
#include "scene/motion.h"
#include "tracer/geometry/transforms.h"
#include "tracer/shapes/build_solids.h"

#include <limits>

namespace orbs::tracer {

namespace {

constexpr std::size_t kNotAdded = std::numeric_limits<std::size_t>::max();

// Of finer meshes the triangles next to the scene are small and near, and floats hold their corners. In
// double they would take several times as long to meet.
constexpr std::size_t kMostExactTriangles = 1024;

// A mesh that changes its shape is never moved by a matrix here.
TriangleMesh copy_mesh(const scene::Mesh& mesh, const Mat4& matrix) {
  TriangleMesh out{mesh.positions, mesh.normals, mesh.uvs, mesh.triangles, mesh.triangle_materials, {}};
  out.second_uvs = mesh.second_uvs;
  if (mesh.end) {  // moving_surface.h normalises what it has interpolated
    out.end_positions = mesh.end->positions;
    out.end_normals = mesh.end->normals;
    return out;
  }
  if (matrix == Mat4{}) {
    for (Vec3f& n : out.normals) n = normalised(n);
    return out;
  }
  const Mat4 back = inverse(matrix).value();  // the loader refuses singular matrices
  for (Vec3f& p : out.positions) p = cast<float>(transform_point(matrix, cast<double>(p)));
  for (Vec3f& n : out.normals) n = cast<float>(normalised(transform_normal(back, cast<double>(n))));
  return out;
}

std::vector<Vec3d> exact_positions(const scene::Mesh& mesh, const Mat4& matrix) {
  std::vector<Vec3d> out;
  out.reserve(mesh.positions.size());
  for (const Vec3f p : mesh.positions) out.push_back(transform_point(matrix, cast<double>(p)));
  return out;
}

// Normals are mapped by the inverse transpose, whose columns these are.
Affine normal_map(const Mat4& matrix) {
  const Mat4 back = inverse(matrix).value();
  Affine out;
  for (std::size_t c = 0; c < 3; ++c) out.axes[c] = cast<float>(Vec3d{back(c, 0), back(c, 1), back(c, 2)});
  return out;
}

}  // namespace

Mat4 relative_to(Mat4 matrix, Vec3d origin) {
  matrix(0, 3) -= origin.x;
  matrix(1, 3) -= origin.y;
  matrix(2, 3) -= origin.z;
  return matrix;
}

void add_meshes(const scene::Scene& scene,
                Vec3d origin,
                const std::vector<bool>& is_vast,
                std::size_t most_copied_triangles,
                World& world) {
  std::vector<int> uses(scene.meshes.size(), 0);
  std::size_t copied = 0;
  for (const auto& instance : scene.instances) {
    ++nth(uses, instance.mesh);
    copied += nth(scene.meshes, instance.mesh).triangles.size();
  }
  std::vector<std::size_t> shared(scene.meshes.size(), kNotAdded);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const auto& instance = scene.instances[i];
    const auto index = static_cast<std::size_t>(instance.mesh);
    const Mat4 matrix = relative_to(instance.matrix, origin);
    RenderObject object;
    for (int m = 0; m < static_cast<int>(scene.materials.size()); ++m)
      object.material_of.push_back(scene::remapped(instance, m));
    const bool is_moving = scene::is_moving(scene, instance);
    if (!is_moving && (copied <= most_copied_triangles || uses[index] == 1)) {
      object.mesh = world.meshes.size();
      world.meshes.push_back(copy_mesh(scene.meshes[index], matrix));
      if (is_vast[i] && scene.meshes[index].triangles.size() <= kMostExactTriangles)
        world.meshes.back().exact_positions = exact_positions(scene.meshes[index], matrix);
    } else {
      if (shared[index] == kNotAdded) {
        shared[index] = world.meshes.size();
        world.meshes.push_back(copy_mesh(scene.meshes[index], Mat4{}));
      }
      object.kind = is_moving ? ObjectKind::MovingMesh : ObjectKind::InstancedMesh;
      object.mesh = shared[index];
      object.to_world = affine(matrix);
      if (is_moving)
        object.end_to_world = affine(relative_to(instance.end_matrix.value_or(instance.matrix), origin));
      else
        object.normal_to_world = normal_map(matrix);
    }
    world.objects.push_back(std::move(object));
  }
}

void add_spheres(const scene::Scene& scene, Vec3d origin, World& world) {
  for (const auto& sphere : scene.spheres) {
    RenderObject object;
    object.kind = ObjectKind::Sphere;
    object.sphere = world.spheres.size();
    world.spheres.push_back({sphere.centre_m - origin, sphere.radius_m, sphere.material});
    world.objects.push_back(std::move(object));
  }
}

void add_solids(const scene::Scene& scene, Vec3d origin, World& world) {
  for (const auto& shape : scene.shapes) {
    if (std::holds_alternative<scene::PluginForm>(shape.form)) continue;
    RenderObject object;
    object.kind = ObjectKind::Solid;
    object.solid = world.solids.size();
    world.solids.push_back(make_solid(shape, origin));
    world.objects.push_back(std::move(object));
  }
}

void add_plugin_shapes(const scene::Scene& scene,
                       Vec3d origin,
                       const PluginLibraries& libraries,
                       World& world) {
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const auto& shape = scene.shapes[i];
    if (!std::holds_alternative<scene::PluginForm>(shape.form)) continue;
    RenderObject object;
    object.kind = ObjectKind::PluginShape;
    object.plugin_shape = world.plugin_shapes.size();
    const auto name = scene::display_name("shape", shape.name, scene.spheres.size() + i);
    world.plugin_shapes.push_back(make_plugin_shape(shape, name, origin, libraries));
    world.objects.push_back(std::move(object));
  }
}

}  // namespace orbs::tracer
