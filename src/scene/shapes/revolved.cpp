#include "scene/shapes/revolved.h"

#include "json/object_reader.h"

#include <algorithm>
#include <cmath>

namespace orbs::scene {

namespace {

// A circle of a surface that turns about y, with the normal in the plane of the axis.
struct Ring {
  double y = 0;
  double radius = 0;
  double normal_out = 0;
  double normal_up = 1;
  double v = 0;
};

// Surfaces between rings, from above to below.
void add_rings(Mesh& mesh, const std::vector<Ring>& rings) {
  const auto first = vertex_count(mesh);
  for (const Ring& ring : rings)
    for (int j = 0; j <= kShapeSegments; ++j) {
      const double phi = turn_rad(j % kShapeSegments);  // the seam's two columns coincide to the bit
      const Vec3d out{std::sin(phi), 0, std::cos(phi)};
      add_vertex(mesh, out * ring.radius + Vec3d{0, ring.y, 0},
                 normalised(out * ring.normal_out + Vec3d{0, ring.normal_up, 0}),
                 {double(j) / kShapeSegments, ring.v});
    }
  add_grid_triangles(mesh, first, static_cast<int>(rings.size()) - 1, kShapeSegments);
}

double radius_at(const RevolvedQuadric& q, double y) {
  return std::sqrt(std::max(0.0, q.a + y * (q.b + y * q.c)));
}

// The side between the heights, from the top; the gradient of x^2 + z^2 - a - b y - c y^2 is its normal.
void add_side(Mesh& mesh, const RevolvedQuadric& q, const std::vector<double>& heights) {
  std::vector<Ring> rings;
  for (const double y : heights) {
    const double radius = radius_at(q, y);
    Ring ring{y, radius, radius, -(q.b / 2 + q.c * y), (y - q.y_low) / (q.y_high - q.y_low)};
    // At an apex the gradient is zero or along the axis; a cone's side has the normal of all its heights.
    if (radius == 0 && q.c > 0) ring = {y, 0, 1, q.b > 0 ? -std::sqrt(q.c) : std::sqrt(q.c), ring.v};
    rings.push_back(ring);
  }
  add_rings(mesh, rings);
}

}  // namespace

bool load_caps(ShapeEntry& entry) { return entry.in.boolean_or("caps", true); }

void add_cap(Mesh& mesh, double y, double radius, bool is_top) {
  if (radius <= 0) return;
  const double up = is_top ? 1 : -1;
  const Ring centre{y, 0, 0, up, 0};
  const Ring rim{y, radius, 0, up, 1};
  add_rings(mesh, is_top ? std::vector{centre, rim} : std::vector{rim, centre});
}

Mesh turned(const RevolvedQuadric& q, const std::vector<double>& heights) {
  Mesh mesh;
  if (q.has_caps) add_cap(mesh, q.y_high, radius_at(q, q.y_high), true);
  add_side(mesh, q, heights);
  if (q.has_caps) add_cap(mesh, q.y_low, radius_at(q, q.y_low), false);
  return mesh;
}

Mesh turned(const RevolvedQuadric& q, int bands) {
  std::vector<double> heights;
  for (int i = 0; i <= bands; ++i) heights.push_back(q.y_high + (q.y_low - q.y_high) * i / bands);
  return turned(q, heights);
}

}  // namespace orbs::scene
