#include "scene/geometry/subdivision/vertex_ring.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace orbs::scene {

namespace {

constexpr double kPi = std::numbers::pi;

Vec3d unit_or_zero(Vec3d v) {
  const double size = largest_magnitude(v);
  return size > 0 && std::isfinite(size) ? normalised(v / size) : Vec3d{};
}

Vec3d mean(const std::vector<Vec3d>& points) {
  Vec3d sum;
  for (const Vec3d p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

// Faces from `first` on, up to the edge that is the end of the last one.
struct Sector {
  std::size_t first = 0;
  std::size_t faces = 0;
};

Vec3d edge_of(const VertexRing& ring, std::size_t i) {
  return ring.edge_ends_m[i % ring.edge_ends_m.size()] - ring.point_m;
}

Vec3d face_of(const VertexRing& ring, std::size_t i) { return ring.opposite_m[i] - ring.point_m; }

Vec3d area_normal(const VertexRing& ring, const Sector& sector) {
  Vec3d sum;
  for (std::size_t i = sector.first; i < sector.first + sector.faces; ++i)
    sum += cross(edge_of(ring, i), edge_of(ring, i + 1));
  return sum;
}

// The direction from a crease into its sector. All masks here are of points relative to the ring's own,
// whose weight is therefore left out. With theta = pi / faces and R = (1 + cos theta) / sin theta:
//   ends of the crease  -R (1 + 2 cos theta)
//   edge i              4 sin(i theta)
//   opposite point i    sin(i theta) + sin((i + 1) theta)
// up to a common factor. For one face R is 0, and so are all others: there it is the sum of both ends.
Vec3d across_crease(const VertexRing& ring, const Sector& sector) {
  const std::size_t k = sector.faces;
  const Vec3d ends = edge_of(ring, sector.first) + edge_of(ring, sector.first + k);
  if (k == 1) return ends;
  const double theta = kPi / static_cast<double>(k);
  const double r = (1 + std::cos(theta)) / std::sin(theta);
  Vec3d sum = ends * (-r * (1 + 2 * std::cos(theta)));
  for (std::size_t i = 0; i < k; ++i) {
    const double here = std::sin(static_cast<double>(i) * theta);
    const double next = std::sin(static_cast<double>(i + 1) * theta);
    if (i > 0) sum += edge_of(ring, sector.first + i) * (4 * here);
    sum += face_of(ring, sector.first + i) * (here + next);
  }
  return sum;
}

Vec3d crease_normal(const VertexRing& ring, const Sector& sector) {
  const Vec3d along = edge_of(ring, sector.first) - edge_of(ring, sector.first + sector.faces);
  return cross(along, across_crease(ring, sector));
}

// The two tangents are the components of the ring in the plane of the second largest eigenvalue.
Vec3d smooth_normal(const VertexRing& ring) {
  const std::size_t n = ring.edge_ends_m.size();
  const double angle = 2 * kPi / static_cast<double>(n);
  const double half = std::cos(angle / 2);
  const double edge_weight = 1 + std::cos(angle) + half * std::sqrt(2 * (9 + std::cos(angle)));
  Vec3d first;
  Vec3d second;
  for (std::size_t i = 0; i < n; ++i) {
    const double here = static_cast<double>(i) * angle;
    const double next = static_cast<double>(i + 1) * angle;
    const Vec3d edge = edge_of(ring, i) * edge_weight;
    first += edge * std::cos(here) + face_of(ring, i) * (std::cos(here) + std::cos(next));
    second += edge * std::sin(here) + face_of(ring, i) * (std::sin(here) + std::sin(next));
  }
  return cross(first, second);
}

Vec3d smooth_point(const VertexRing& ring) {
  const auto n = static_cast<double>(ring.edge_ends_m.size());
  return (n * ring.point_m + 4 * mean(ring.edge_ends_m) + mean(ring.opposite_m)) / (n + 5);
}

std::vector<Sector> sectors_of(const VertexRing& ring) {
  std::vector<Sector> sectors;
  for (std::size_t i = 0; i < ring.opposite_m.size(); ++i) {
    if (sectors.empty() || ring.is_sharp[i]) sectors.push_back({i, 0});
    ++sectors.back().faces;
  }
  return sectors;
}

// One step of the ring about its point, which is the origin before and after; returns where the point moved.
Vec3d step(VertexRing& ring) {
  const std::size_t n = ring.edge_ends_m.size();
  const auto old = ring.edge_ends_m;
  for (std::size_t i = 0; i < n; ++i)
    ring.opposite_m[i] = (old[i] + ring.opposite_m[i] + old[(i + 1) % n]) / 4;
  for (std::size_t i = 0; i < n; ++i)
    ring.edge_ends_m[i] =
        ring.is_sharp[i] ? old[i] / 2 : (old[i] + ring.opposite_m[i] + ring.opposite_m[(i + n - 1) % n]) / 4;
  const Vec3d moved = (mean(old) + mean(ring.opposite_m)) / static_cast<double>(n);
  for (Vec3d& p : ring.edge_ends_m) p = p - moved;
  for (Vec3d& p : ring.opposite_m) p = p - moved;
  return moved;
}

}  // namespace

RingLimit limit_by_steps(const VertexRing& ring, int steps) {
  VertexRing left = ring;
  for (Vec3d& p : left.edge_ends_m) p = p - ring.point_m;
  for (Vec3d& p : left.opposite_m) p = p - ring.point_m;
  left.point_m = {};
  Vec3d point = ring.point_m;
  double scale = 1;
  for (int i = 0; i < steps; ++i) {
    point += scale * step(left);
    double size = 0;
    for (const Vec3d p : left.edge_ends_m) size = std::max(size, largest_magnitude(p));
    if (!(size > 0)) break;
    // Grown back to size 1, so that the differences that the normal comes from keep their digits.
    for (Vec3d& p : left.edge_ends_m) p = p / size;
    for (Vec3d& p : left.opposite_m) p = p / size;
    scale *= size;
  }
  return {point,
          {unit_or_zero(area_normal(left, {0, left.opposite_m.size()}))},
          std::vector<std::uint32_t>(ring.opposite_m.size(), 0)};
}

RingLimit limit_of(const VertexRing& ring) {
  // The second largest eigenvalue is below 0.7 for every valence: 0.7^120 is 3e-19.
  constexpr int kSteps = 120;
  const auto sharp_edges = std::count(ring.is_sharp.begin(), ring.is_sharp.end(), true);
  if (sharp_edges == 1 && !ring.is_corner) return limit_by_steps(ring, kSteps);
  const bool is_crease = sharp_edges == 2 && !ring.is_corner;
  const bool is_smooth = sharp_edges == 0 && !ring.is_corner;
  RingLimit limit{ring.point_m, {}, {}};
  if (is_smooth) limit.point_m = smooth_point(ring);
  Vec3d crease_ends;
  for (std::size_t i = 0; i < ring.is_sharp.size(); ++i)
    if (ring.is_sharp[i]) crease_ends += ring.edge_ends_m[i];
  // The limit of a uniform cubic B-spline at a knot.
  if (is_crease) limit.point_m = (4 * ring.point_m + crease_ends) / 6;
  for (const Sector& sector : sectors_of(ring)) {
    limit.sector.insert(limit.sector.end(), sector.faces, static_cast<std::uint32_t>(limit.normals.size()));
    limit.normals.push_back(unit_or_zero(is_smooth   ? smooth_normal(ring)
                                         : is_crease ? crease_normal(ring, sector)
                                                     : area_normal(ring, sector)));
  }
  return limit;
}

}  // namespace orbs::scene
