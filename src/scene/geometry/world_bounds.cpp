#include "scene/geometry/world_bounds.h"

#include "base/nth.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace orbs::scene {

namespace {

WorldBounds bounds_of(const std::vector<Vec3d>& vertices) {
  WorldBounds out{vertices.front(), vertices.front()};
  for (const Vec3d v : vertices) {
    out.low = {std::fmin(out.low.x, v.x), std::fmin(out.low.y, v.y), std::fmin(out.low.z, v.z)};
    out.high = {std::fmax(out.high.x, v.x), std::fmax(out.high.y, v.y), std::fmax(out.high.z, v.z)};
  }
  return out;
}

Vec3d origin_of(const std::vector<Vec3d>& vertices) {
  constexpr double kMostExtents = 64;
  if (vertices.empty()) return {};
  const auto [low, high] = bounds_of(vertices);
  const double extent = largest_magnitude(high - low);
  const double farthest = std::fmax(largest_magnitude(low), largest_magnitude(high));
  // Also false if a number is not finite: the check of the mesh says so.
  if (!(extent > 0 && farthest > kMostExtents * extent && std::isfinite(farthest))) return {};
  // A multiple of a power of two, so that the same mesh at places that differ by such multiples becomes the
  // same floats.
  const double step = std::exp2(std::ceil(std::log2(extent)));
  const auto nearest = [&](double m) { return step * std::round(m / step); };
  const Vec3d middle = (low + high) * 0.5;
  return {nearest(middle.x), nearest(middle.y), nearest(middle.z)};
}

}  // namespace

PlacedVertices placed_vertices(const std::vector<Vec3d>& vertices) {
  PlacedVertices out{{}, origin_of(vertices)};
  out.positions.reserve(vertices.size());
  for (const Vec3d v : vertices) out.positions.push_back(cast<float>(v - out.origin_m));
  return out;
}

namespace {

WorldBounds around(const Mat4& matrix, Vec3d half) {
  const Vec3d centre = transform_point(matrix, {});
  const auto reach = [&](std::size_t row) {
    return std::fabs(matrix(row, 0)) * half.x + std::fabs(matrix(row, 1)) * half.y +
           std::fabs(matrix(row, 2)) * half.z;
  };
  const Vec3d extent{reach(0), reach(1), reach(2)};
  return {centre - extent, centre + extent};
}

}  // namespace

WorldBounds joined(const WorldBounds& a, const WorldBounds& b) {
  return {{std::fmin(a.low.x, b.low.x), std::fmin(a.low.y, b.low.y), std::fmin(a.low.z, b.low.z)},
          {std::fmax(a.high.x, b.high.x), std::fmax(a.high.y, b.high.y), std::fmax(a.high.z, b.high.z)}};
}

WorldBounds world_bounds(const Scene& scene, const Instance& instance) {
  std::optional<WorldBounds> bounds;
  const auto add = [&](const std::vector<Vec3f>& positions, const Mat4& matrix) {
    for (const Vec3f position : positions) {
      const Vec3d p = transform_point(matrix, cast<double>(position));
      bounds = bounds ? joined(*bounds, {p, p}) : WorldBounds{p, p};
    }
  };
  // At any time a vertex is a mean, with weights that add up to 1, of the four combinations of start and end.
  const auto& mesh = mesh_of(scene, instance);
  for (const Mat4& matrix : {instance.matrix, instance.end_matrix.value_or(instance.matrix)}) {
    add(mesh.positions, matrix);
    if (mesh.end) add(mesh.end->positions, matrix);
    if (!instance.end_matrix) break;
  }
  return bounds.value_or(WorldBounds{});
}

namespace {

WorldBounds bounds_of(const Sphere& sphere) {
  const Vec3d extent{sphere.radius_m, sphere.radius_m, sphere.radius_m};
  return {sphere.centre_m - extent, sphere.centre_m + extent};
}

// Nothing of light from afar: its place means nothing.
std::optional<WorldBounds> bounds_of(const Light& light) {
  if (std::holds_alternative<DirectionalShape>(light.shape)) return std::nullopt;
  return around(light.matrix, half_size(light.shape));
}

// Nothing of a half-space.
std::optional<WorldBounds> bounds_of(const Shape& shape) {
  std::optional<WorldBounds> bounds;
  for (const Vec3d corner : bounding_corners(shape)) {
    const WorldBounds one{corner, corner};
    bounds = bounds ? joined(*bounds, one) : one;
  }
  return bounds;
}

std::optional<WorldBounds> with_shapes_and_lights(const Scene& scene, std::optional<WorldBounds> bounds) {
  const auto add = [&](const WorldBounds& one) { bounds = bounds ? joined(*bounds, one) : one; };
  for (const auto& sphere : scene.spheres) add(bounds_of(sphere));
  for (const auto& shape : scene.shapes)
    if (const auto one = bounds_of(shape)) add(*one);
  for (const auto& light : scene.lights)
    if (const auto one = bounds_of(light)) add(*one);
  return bounds;
}

}  // namespace

std::optional<WorldBounds> world_bounds(const Scene& scene) {
  std::optional<WorldBounds> bounds;
  for (const auto& instance : scene.instances) {
    const auto one = world_bounds(scene, instance);
    bounds = bounds ? joined(*bounds, one) : one;
  }
  return with_shapes_and_lights(scene, bounds);
}

namespace {

std::vector<WorldBounds> rough_instance_bounds(const Scene& scene) {
  std::vector<WorldBounds> of_meshes;
  for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh)
    of_meshes.push_back(world_bounds(scene, {"", static_cast<int>(mesh), Mat4{}, {}}));
  std::vector<WorldBounds> bounds;
  for (const auto& instance : scene.instances) {
    const auto& box = nth(of_meshes, instance.mesh);
    const auto placed = [&](const Mat4& matrix) {
      return around(matrix * translation((box.low + box.high) * 0.5), (box.high - box.low) * 0.5);
    };
    bounds.push_back(placed(instance.matrix));
    if (instance.end_matrix) bounds.back() = joined(bounds.back(), placed(*instance.end_matrix));
  }
  return bounds;
}

}  // namespace

std::optional<WorldBounds> rough_bounds(const Scene& scene) {
  std::optional<WorldBounds> bounds;
  for (const auto& one : rough_instance_bounds(scene)) bounds = bounds ? joined(*bounds, one) : one;
  return with_shapes_and_lights(scene, bounds);
}

VastObjects vast_objects(const Scene& scene, double ratio) {
  auto bounds = rough_instance_bounds(scene);
  const WorldBounds at_camera{scene.camera.position_m, scene.camera.position_m};
  for (const auto& light : scene.lights) bounds.push_back(bounds_of(light).value_or(at_camera));
  for (const auto& sphere : scene.spheres) bounds.push_back(bounds_of(sphere));
  for (const auto& shape : scene.shapes)
    if (const auto one = bounds_of(shape)) bounds.push_back(*one);
  std::vector<std::size_t> by_size(bounds.size());
  std::iota(by_size.begin(), by_size.end(), std::size_t{0});
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](std::size_t a, std::size_t b) { return radius_of(bounds[a]) < radius_of(bounds[b]); });
  WorldBounds smaller = at_camera;
  std::vector<bool> is_vast(bounds.size(), false);
  bool all_that_follow = false;
  for (const std::size_t i : by_size) {
    all_that_follow =
        all_that_follow || (radius_of(smaller) > 0 && radius_of(bounds[i]) > ratio * radius_of(smaller));
    is_vast[i] = all_that_follow;
    if (!all_that_follow) smaller = joined(smaller, bounds[i]);
  }
  const auto lights = is_vast.begin() + static_cast<std::ptrdiff_t>(scene.instances.size());
  return {{is_vast.begin(), lights}, {lights, lights + static_cast<std::ptrdiff_t>(scene.lights.size())}};
}

}  // namespace orbs::scene
