#include "scene/geometry/generators/round.h"

#include "base/error.h"
#include "scene/geometry/mesh.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

double turn_rad(int part, int whole) { return 2 * std::numbers::pi * part / whole; }

}  // namespace

Mesh make_sphere(const SphereParameters& parameters) {
  const int n = parameters.segments;
  if (n % 2 != 0)
    throw InputError(
        fmt::format("a sphere needs an even number of segments, not {}: half of them are bands", n));
  Mesh mesh;
  for (int i = 0; i <= n / 2; ++i)
    for (int j = 0; j <= n; ++j) {
      const double theta = turn_rad(i, n);
      const double phi = turn_rad(j % n, n);  // the seam's two columns coincide to the bit
      const Vec3d normal{std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)};
      add_vertex(mesh, normal * parameters.radius_m, normal, {double(j) / n, (1.0 - i) / (n - 1)});
    }
  add_grid_triangles(mesh, 0, n / 2, n);
  return mesh;
}

Mesh make_torus(const TorusParameters& parameters) {
  const int ring = parameters.ring_segments;
  const int tube = parameters.tube_segments;
  Mesh mesh;
  for (int s = 0; s <= ring; ++s)
    for (int f = 0; f <= tube; ++f) {
      const double a = turn_rad(s % ring, ring);
      const double b = turn_rad(f % tube, tube);
      const Vec3d normal{std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)};
      const Vec3d middle = Vec3d{std::cos(a), std::sin(a), 0} * parameters.major_radius_m;
      add_vertex(mesh, middle + normal * parameters.minor_radius_m, normal,
                 {double(f) / tube, double(s) / ring});
    }
  add_grid_triangles(mesh, 0, ring, tube);
  return mesh;
}

}  // namespace orbs::scene
