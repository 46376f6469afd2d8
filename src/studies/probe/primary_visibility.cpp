#include "studies/probe/primary_visibility.h"

#include "base/nth.h"
#include "base/parallel.h"
#include "scene/camera_frame.h"
#include "scene/geometry/uv_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace orbs::studies {

namespace {

// A triangle prepared for rays from the camera. With corners v0, v1, v2 relative to the camera, a ray along d
// meets the plane where d t = b0' v0 + b1' v1 + b2' v2 scaled to a sum of 1, so b' = M^-1 d with M = [v0 v1
// v2]: the rows of M^-1 are all that is needed (Olano and Greer, "Triangle scan conversion using 2D
// homogeneous coordinates", 1997, section 3). Corners behind the camera need no special care.
struct TriangleSetup {
  std::array<Vec3d, 3> rows;  // in the camera's frame: right, up, forward
  std::array<Vec2f, 3> uvs;
  std::array<Vec3d, 3> normals;  // in the world
  Vec3f along_u;
  Vec3f along_v;
  int object = kNoObject;
  int first_row = 0;  // bounds of the pixels that it may touch
  int last_row = 0;
  int first_column = 0;
  int last_column = 0;
};

struct View {
  scene::CameraFrame frame;
  Vec3d position;
  int width = 0;
  int height = 0;

  Vec3d to_camera(Vec3d world_direction) const {
    return {dot(world_direction, frame.right), dot(world_direction, frame.up),
            dot(world_direction, frame.forward)};
  }
  // Direction through a point of the image, in pixels from its upper left corner; z is 1.
  Vec3d camera_direction(double x, double y) const {
    return {(2 * x / width - 1) * frame.half_width + frame.centre.x,
            (1 - 2 * y / height) * frame.half_height + frame.centre.y, 1};
  }
};

// Sets the pixels that a triangle may touch: the box of its projected corners, or all pixels if one corner is
// not in front of the camera.
void bound(const std::array<Vec3d, 3>& corners, const View& view, TriangleSetup& setup) {
  setup.last_row = view.height - 1;
  setup.last_column = view.width - 1;
  double low_x = std::numeric_limits<double>::infinity();
  double low_y = low_x;
  double high_x = -low_x;
  double high_y = -low_x;
  for (const Vec3d& c : corners) {
    if (c.z <= 0) return;
    const double x = ((c.x / c.z - view.frame.centre.x) / view.frame.half_width + 1) * view.width / 2;
    const double y = (1 - (c.y / c.z - view.frame.centre.y) / view.frame.half_height) * view.height / 2;
    low_x = std::min(low_x, x);
    high_x = std::max(high_x, x);
    low_y = std::min(low_y, y);
    high_y = std::max(high_y, y);
  }
  // One pixel more, for the grid's margin and for rounding. Clamped as double, because a nearby triangle seen
  // edge-on projects beyond the range of int.
  const auto pixel = [](double at, int count) {
    return static_cast<int>(std::clamp(std::floor(at), -1.0, static_cast<double>(count)));
  };
  setup.first_row = std::max(0, pixel(low_y, view.height) - 1);
  setup.last_row = std::min(view.height - 1, pixel(high_y, view.height) + 1);
  setup.first_column = std::max(0, pixel(low_x, view.width) - 1);
  setup.last_column = std::min(view.width - 1, pixel(high_x, view.width) + 1);
}

void add_instance(const scene::Scene& scene,
                  const scene::Instance& instance,
                  const View& view,
                  std::vector<TriangleSetup>& out) {
  const auto& mesh = nth(scene.meshes, instance.mesh);
  const Mat4 back = inverse(instance.matrix).value();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<Vec3d, 3> v;
    TriangleSetup setup;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto index = mesh.triangles[t][k];
      v[k] = view.to_camera(transform_point(instance.matrix, cast<double>(mesh.positions[index])) -
                            view.position);
      setup.uvs[k] = mesh.uvs[index];
      setup.normals[k] = normalised(transform_normal(back, cast<double>(mesh.normals[index])));
    }
    if (const auto directions = scene::uv_frame(mesh, t)) {
      setup.along_u = cast<float>(transform_direction(instance.matrix, directions->per_u));
      setup.along_v = cast<float>(transform_direction(instance.matrix, directions->per_v));
    }
    const double volume = dot(v[0], cross(v[1], v[2]));
    if (volume == 0) continue;                                // no area, or seen exactly edge-on
    if (v[0].z <= 0 && v[1].z <= 0 && v[2].z <= 0) continue;  // behind the camera
    setup.rows = {cross(v[1], v[2]) / volume, cross(v[2], v[0]) / volume, cross(v[0], v[1]) / volume};
    setup.object = scene::remapped(instance, mesh.triangle_materials[t]);
    bound(v, view, setup);
    out.push_back(setup);
  }
}

struct LightSetup {
  const scene::Light* light = nullptr;
  Mat4 to_local;
  Vec3d origin;  // position of the camera in the light's frame
  int object = kNoObject;
};

struct NearestHit {
  VisibleSurface surface;
  double inverse_distance = 0;  // 0 without a hit
};

void intersect_triangle(const TriangleSetup& triangle, Vec3d d, NearestHit& nearest) {
  const double b0 = dot(triangle.rows[0], d);
  const double b1 = dot(triangle.rows[1], d);
  const double b2 = dot(triangle.rows[2], d);
  if (!(b0 >= 0 && b1 >= 0 && b2 >= 0)) return;  // also true if a sliver's rows are not finite
  const double sum = b0 + b1 + b2;  // 1 / distance, since d t = sum of b' v with weights of sum 1
  if (!(sum > nearest.inverse_distance)) return;
  const auto mix = [&](float a, float b, float c) {
    return static_cast<float>(
        (b0 * static_cast<double>(a) + b1 * static_cast<double>(b) + b2 * static_cast<double>(c)) / sum);
  };
  const auto& n = triangle.normals;
  nearest.inverse_distance = sum;
  nearest.surface = {triangle.object,
                     mix(triangle.uvs[0].x, triangle.uvs[1].x, triangle.uvs[2].x),
                     mix(triangle.uvs[0].y, triangle.uvs[1].y, triangle.uvs[2].y),
                     1 / sum,
                     cast<float>(normalised(n[0] * b0 + n[1] * b1 + n[2] * b2)),
                     triangle.along_u,
                     triangle.along_v};
}

void intersect_light(const LightSetup& light, Vec3d world_direction, NearestHit& nearest) {
  const Vec3d d = transform_direction(light.to_local, world_direction);
  const auto hit =
      std::visit([&](const auto& shape) { return scene::hit(shape, light.origin, d); }, light.light->shape);
  if (1 / hit.distance <= nearest.inverse_distance) return;
  nearest.inverse_distance = 1 / hit.distance;
  nearest.surface = {hit.is_front ? light.object : kNoObject, 0, 0, hit.distance, {}, {}, {}};
}

// A scene prepared for visibility tests.
struct VisibilityScene {
  View view;
  std::vector<TriangleSetup> triangles;
  std::vector<LightSetup> lights;
  std::vector<std::vector<std::size_t>> triangles_of_row;  // that may touch each row of pixels
};

VisibilityScene prepare(const scene::Scene& scene) {
  VisibilityScene prepared{{scene::camera_frame(scene.camera), scene.camera.position_m, scene.camera.width_px,
                            scene.camera.height_px},
                           {},
                           {},
                           {}};
  for (const auto& instance : scene.instances)
    add_instance(scene, instance, prepared.view, prepared.triangles);
  prepared.triangles_of_row.resize(static_cast<std::size_t>(prepared.view.height));
  for (std::size_t i = 0; i < prepared.triangles.size(); ++i)
    for (int y = prepared.triangles[i].first_row; y <= prepared.triangles[i].last_row; ++y)
      nth(prepared.triangles_of_row, y).push_back(i);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const auto& light = scene.lights[i];
    const Mat4 to_local = inverse(light.matrix).value();
    prepared.lights.push_back({&light, to_local, transform_point(to_local, prepared.view.position),
                               static_cast<int>(scene.materials.size() + i)});
  }
  return prepared;
}

void find_surfaces(const VisibilityScene& prepared,
                   const VisibilityGrid& grid,
                   Pixel pixel,
                   std::span<VisibleSurface> out) {
  const auto side = static_cast<std::size_t>(grid.per_side);
  const double step = (1 + 2 * grid.margin_px) / (grid.per_side - 1);
  const auto& frame = prepared.view.frame;
  std::vector<Vec3d> directions;
  for (std::size_t k = 0; k < side * side; ++k) {
    const std::size_t row = k / side;
    directions.push_back(
        prepared.view.camera_direction(pixel.x - grid.margin_px + step * static_cast<double>(k % side),
                                       pixel.y - grid.margin_px + step * static_cast<double>(row)));
  }
  std::vector<NearestHit> nearest(side * side);
  for (const std::size_t index : nth(prepared.triangles_of_row, pixel.y)) {
    const auto& triangle = prepared.triangles[index];
    if (pixel.x < triangle.first_column || pixel.x > triangle.last_column) continue;
    for (std::size_t k = 0; k < nearest.size(); ++k) intersect_triangle(triangle, directions[k], nearest[k]);
  }
  for (std::size_t k = 0; k < nearest.size(); ++k) {
    const Vec3d world = frame.right * directions[k].x + frame.up * directions[k].y + frame.forward;
    for (const auto& light : prepared.lights) intersect_light(light, world, nearest[k]);
    out[k] = nearest[k].surface;
  }
}

}  // namespace

std::vector<VisibleSurface> visible_surfaces_of_pixels(const scene::Scene& scene,
                                                       const std::vector<Pixel>& pixels,
                                                       const VisibilityGrid& grid,
                                                       int threads) {
  const VisibilityScene prepared = prepare(scene);
  const auto side = static_cast<std::size_t>(grid.per_side);
  const std::size_t each = side * side;
  std::vector<VisibleSurface> surfaces(pixels.size() * each);
  for_each_index(static_cast<int>(pixels.size()), threads, [&](int i) {
    const auto index = static_cast<std::size_t>(i);
    find_surfaces(prepared, grid, pixels[index], std::span(surfaces).subspan(index * each, each));
  });
  return surfaces;
}

std::vector<VisibleSurface> primary_visibility(const scene::Scene& scene,
                                               const VisibilityGrid& grid,
                                               int threads) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < scene.camera.height_px; ++y)
    for (int x = 0; x < scene.camera.width_px; ++x) pixels.push_back({x, y});
  return visible_surfaces_of_pixels(scene, pixels, grid, threads);
}

}  // namespace orbs::studies
