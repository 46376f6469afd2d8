#include "scene/geometry/generators/water.h"

#include "scene/geometry/mesh.h"

#include <cmath>
#include <numbers>

namespace orbs::scene {

namespace {

struct Wave {
  double share;      // of the amplitude; the shares add up to 1
  double frequency;  // waves per wavelength_m
  double heading_deg;
  double phase_rad;
};
constexpr std::array<Wave, 3> kWaves{Wave{0.5, 1, 20, 0}, Wave{0.3, 1.31, 110, 1}, Wave{0.2, 1.73, 65, 2}};

struct Surface {
  double height_m;
  Vec3d normal;
};

Surface surface_at(const WaterParameters& water, double x_m, double z_m) {
  double height_m = 0;
  double slope_x = 0;
  double slope_z = 0;
  for (const Wave& wave : kWaves) {
    const double heading_rad = wave.heading_deg * std::numbers::pi / 180;
    const double per_m = 2 * std::numbers::pi * wave.frequency / water.wavelength_m;
    const double kx = per_m * std::cos(heading_rad);
    const double kz = per_m * std::sin(heading_rad);
    const double angle = kx * x_m + kz * z_m + wave.phase_rad;
    height_m += water.amplitude_m * wave.share * std::sin(angle);
    slope_x += water.amplitude_m * wave.share * kx * std::cos(angle);
    slope_z += water.amplitude_m * wave.share * kz * std::cos(angle);
  }
  return {height_m, normalised(Vec3d{-slope_x, 1, -slope_z})};
}

Vec3d place(const WaterParameters& water, Vec2d uv, double y_m) {
  return {(2 * uv.x - 1) * water.half_width_m, y_m, (2 * uv.y - 1) * water.half_length_m};
}

Surface surface_at(const WaterParameters& water, Vec2d uv) {
  const Vec3d at = place(water, uv, 0);
  return surface_at(water, at.x, at.z);
}

/// Step `i` of `n` between corners of the unit square. It equals i / n of the top's grid to the bit, so that
/// edges meet.
Vec2d between(Vec2d from, Vec2d to, int i, int n) {
  return {(from.x * (n - i) + to.x * i) / n, (from.y * (n - i) + to.y * i) / n};
}

/// Adds a strip from the edge of the waves down to the bottom, from corner to corner of the unit square.
void add_side(Mesh& mesh, const WaterParameters& water, Vec2d from, Vec2d to, Vec3d normal) {
  const std::uint32_t first = vertex_count(mesh);
  for (int i = 0; i <= water.segments; ++i) {
    const Vec2d uv = between(from, to, i, water.segments);
    add_vertex(mesh, place(water, uv, surface_at(water, uv).height_m), normal, uv);
    add_vertex(mesh, place(water, uv, -water.depth_m), normal, uv);
  }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(water.segments); ++i) {
    const std::uint32_t top = first + 2 * i;
    mesh.triangles.push_back({top, top + 1, top + 3});
    mesh.triangles.push_back({top, top + 3, top + 2});
  }
}

void add_bottom_fan(Mesh& mesh, const WaterParameters& water, Vec2d from, Vec2d to) {
  const Vec3d down{0, -1, 0};
  const std::uint32_t centre = add_vertex(mesh, place(water, {0.5, 0.5}, -water.depth_m), down, {0.5, 0.5});
  for (int i = 0; i <= water.segments; ++i) {
    const Vec2d uv = between(from, to, i, water.segments);
    const std::uint32_t rim = add_vertex(mesh, place(water, uv, -water.depth_m), down, uv);
    if (i > 0) mesh.triangles.push_back({centre, rim, rim - 1});
  }
}

}  // namespace

Mesh make_water(const WaterParameters& parameters) {
  const int n = parameters.segments;
  Mesh mesh;
  for (int row = 0; row <= n; ++row)
    for (int column = 0; column <= n; ++column) {
      const Vec2d uv{double(column) / n, double(row) / n};
      const Surface surface = surface_at(parameters, uv);
      add_vertex(mesh, place(parameters, uv, surface.height_m), surface.normal, uv);
    }
  add_grid_triangles(mesh, 0, n, n);
  // The corners are visited so that, seen from above, the outside is always on the same side.
  constexpr std::array<Vec2d, 5> kCorners{Vec2d{0, 1}, Vec2d{1, 1}, Vec2d{1, 0}, Vec2d{0, 0}, Vec2d{0, 1}};
  constexpr std::array<Vec3d, 4> kNormals{Vec3d{0, 0, 1}, Vec3d{1, 0, 0}, Vec3d{0, 0, -1}, Vec3d{-1, 0, 0}};
  for (std::size_t i = 0; i < 4; ++i) add_side(mesh, parameters, kCorners[i], kCorners[i + 1], kNormals[i]);
  for (std::size_t i = 0; i < 4; ++i) add_bottom_fan(mesh, parameters, kCorners[i], kCorners[i + 1]);
  return mesh;
}

}  // namespace orbs::scene
