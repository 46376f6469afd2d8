#include "analytic/form_factor.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbs::analytic {

namespace {

constexpr double kPi = std::numbers::pi;

// std::acos answers NaN where rounding has left [-1, 1].
double safe_acos(double x) { return std::acos(std::clamp(x, -1.0, 1.0)); }

Vec3d front_of(const Corners& corners) { return cross(corners[1] - corners[0], corners[2] - corners[0]); }

Vec3d middle_of(const Corners& corners) {
  Vec3d sum;
  for (const auto& corner : corners) sum += corner;
  return sum / static_cast<double>(corners.size());
}

// Normals of the planes through the origin and the edges; they point into the cone that the polygon fills.
std::vector<Vec3d> cone_of(const Corners& corners) {
  const auto middle = middle_of(corners);
  std::vector<Vec3d> planes;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto normal = cross(corners[i], corners[(i + 1) % corners.size()]);
    planes.push_back(dot(normal, middle) < 0 ? -normal : normal);
  }
  return planes;
}

Corners seen_through(Corners corners, const Corners& window) {
  for (const auto& inward : cone_of(window))
    if (!corners.empty()) corners = clipped(corners, inward);
  return corners;
}

bool is_beside(const Corners& corners, Vec3d inward) {
  return std::all_of(corners.begin(), corners.end(), [&](Vec3d corner) { return dot(inward, corner) <= 0; });
}

// Adds to `pieces` the parts of a polygon that lie outside of the cone.
void add_outside(Corners rest, const std::vector<Vec3d>& cone, std::vector<Corners>& pieces) {
  if (std::any_of(cone.begin(), cone.end(), [&](Vec3d inward) { return is_beside(rest, inward); })) {
    pieces.push_back(std::move(rest));
    return;
  }
  for (const auto& inward : cone) {
    if (auto outside = clipped(rest, -inward); outside.size() >= 3) pieces.push_back(std::move(outside));
    rest = clipped(rest, inward);
    if (rest.size() < 3) return;
  }
}

struct CoverageOf {
  const Corners& window;
  const std::vector<Corners>& blockers;
  Vec3d point;
  Vec3d normal;

  Coverage operator()(const registry::FlatPolygon& polygon) const {
    auto corners = seen_from(point, polygon.corners);
    if (lies_in_plane(corners)) return {};
    const bool shows_front = dot(front_of(corners), corners.front()) < 0;
    if (!window.empty()) corners = seen_through(std::move(corners), seen_from(point, window));
    if (blockers.empty()) return {polygon_form_factor(corners, normal), shows_front};
    corners = clipped(corners, normal);
    double sum = 0;
    if (corners.size() >= 3)
      for (const auto& piece : unhidden(corners, blockers)) sum += polygon_form_factor(piece, normal);
    return {sum, shows_front};
  }
  Coverage operator()(const registry::RoundDisk& disk) const {
    constexpr double kParallel = 1e-9;
    if (std::fabs(std::fabs(dot(disk.normal, normal)) - 1) > kParallel || !window.empty())
      throw InputError("a disk must be parallel to the surface that it lights, and have no window");
    const auto to_centre = disk.centre - point;
    const double height = dot(to_centre, normal);
    if (height <= 0) return {};
    const double aside = length(to_centre - normal * height);
    return {parallel_disk_form_factor(height, aside, disk.radius_m), dot(disk.normal, normal) < 0};
  }
  Coverage operator()(const registry::FormulaSphere& sphere) const {
    if (!window.empty()) throw InputError("a sphere that lights has no window");
    return {sphere_form_factor(sphere.centre - point, sphere.radius_m, normal), true};
  }
};

}  // namespace

Corners seen_from(Vec3d point, const Corners& corners) {
  auto out = corners;
  for (auto& corner : out) corner = corner - point;
  return out;
}

Corners clipped(const Corners& corners, Vec3d inward, double offset) {
  Corners out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& a = corners[i];
    const auto& b = corners[(i + 1) % corners.size()];
    const double at_a = dot(inward, a) - offset;
    const double at_b = dot(inward, b) - offset;
    if (at_a >= 0) out.push_back(a);
    if ((at_a < 0) != (at_b < 0)) out.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  return out;
}

std::vector<Corners> unhidden(const Corners& corners, const std::vector<Corners>& blockers) {
  auto plane = normalised(front_of(corners));
  if (dot(plane, corners.front()) > 0) plane = -plane;  // towards the origin
  const double offset = dot(plane, corners.front());
  constexpr double kAbove_m = 1e-9;  // what lies in the polygon's own plane hides nothing
  std::vector<Corners> pieces{corners};
  for (const auto& whole : blockers) {
    const auto blocker = clipped(whole, plane, offset + kAbove_m);
    if (blocker.size() < 3) continue;
    const auto cone = cone_of(blocker);
    std::vector<Corners> left;
    for (auto& piece : pieces) add_outside(std::move(piece), cone, left);
    pieces = std::move(left);
  }
  return pieces;
}

bool lies_in_plane(const Corners& corners) {
  constexpr double kInPlane_m = 1e-9;
  return std::fabs(dot(normalised(front_of(corners)), corners.front())) <= kInPlane_m;
}

double polygon_form_factor(const Corners& corners, Vec3d normal) {
  const auto above = clipped(corners, normal);
  if (above.size() < 3) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < above.size(); ++i) {
    const auto& a = above[i];
    const auto& b = above[(i + 1) % above.size()];
    const auto across = cross(a, b);
    const double size = length(across);
    if (size > 0) sum += std::atan2(size, dot(a, b)) * dot(normal, across) / size;
  }
  return std::fabs(sum) / (2 * kPi);
}

double sphere_form_factor(Vec3d centre, double radius, Vec3d normal) {
  const double distance = length(centre);
  if (distance <= radius) return 0;
  const double s = radius / distance;
  const double sigma = std::asin(s);
  const double cos_theta = std::clamp(dot(normal, centre) / distance, -1.0, 1.0);
  const double theta = std::acos(cos_theta);
  if (theta + sigma <= kPi / 2) return cos_theta * s * s;
  if (theta - sigma >= kPi / 2) return 0;
  const double cos_sigma = std::cos(sigma);
  const double sin_theta = std::sin(theta);
  const double phi = safe_acos(-cos_theta / sin_theta * cos_sigma / s);
  const double covered =
      safe_acos(cos_sigma / sin_theta) + s * s * cos_theta * phi - s * cos_sigma * sin_theta * std::sin(phi);
  return std::max(0.0, covered / kPi);
}

double parallel_disk_form_factor(double height, double aside, double radius) {
  const double h2 = height * height;
  const double a2 = aside * aside;
  const double r2 = radius * radius;
  return (1 - (a2 + h2 - r2) / std::sqrt((a2 + h2 + r2) * (a2 + h2 + r2) - 4 * a2 * r2)) / 2;
}

Coverage coverage(const registry::AnalyticShape& shape,
                  const Corners& window,
                  const std::vector<Corners>& blockers,
                  Vec3d point,
                  Vec3d normal) {
  return std::visit(CoverageOf{window, blockers, point, normal}, shape);
}

}  // namespace orbs::analytic
