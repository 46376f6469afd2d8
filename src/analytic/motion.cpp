#include "analytic/motion.h"

#include "analytic/reflectance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace orbs::analytic {

Corners corners_at(const registry::FlatPolygon& polygon, double time) {
  if (polygon.end_corners.empty()) return polygon.corners;
  Corners corners;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i)
    corners.push_back(polygon.corners[i] * (1 - time) + polygon.end_corners[i] * time);
  return corners;
}

namespace {

// Above zero where the point is on the inner side of edge `i`.
double side_of_edge(const registry::FlatPolygon& polygon, std::size_t i, Vec3d point, double time) {
  const auto& start = polygon.corners;
  const auto normal = cross(start[1] - start[0], start[2] - start[0]);
  const auto corners = corners_at(polygon, time);
  const auto edge = corners[(i + 1) % corners.size()] - corners[i];
  return dot(cross(edge, point - corners[i]), normal);
}

// Real roots of a + b t + c t^2.
std::vector<double> roots(double a, double b, double c) {
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return {};
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  return {q / c, a / q};  // infinite or no number where the degree is lower
}

bool is_inside(const registry::FlatPolygon& polygon, Vec3d point, double time) {
  for (std::size_t i = 0; i < polygon.corners.size(); ++i)
    if (side_of_edge(polygon, i, point, time) < 0) return false;
  return true;
}

}  // namespace

TimeIntervals times_inside(const registry::FlatPolygon& polygon, Vec3d point, const TimeInterval& within) {
  std::vector<double> times{within.from, within.to};
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const double start = side_of_edge(polygon, i, point, 0);
    const double middle = side_of_edge(polygon, i, point, 0.5);
    const double end = side_of_edge(polygon, i, point, 1);
    for (const double t : roots(start, -3 * start + 4 * middle - end, 2 * start - 4 * middle + 2 * end))
      if (t > within.from && t < within.to) times.push_back(t);
  }
  std::sort(times.begin(), times.end());
  TimeIntervals inside;
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
    if (is_inside(polygon, point, (times[i] + times[i + 1]) / 2)) inside.push_back({times[i], times[i + 1]});
  return inside;
}

TimeIntervals common(const TimeIntervals& a, const TimeIntervals& b) {
  TimeIntervals out;
  for (const auto& x : a)
    for (const auto& y : b) {
      const TimeInterval both{std::max(x.from, y.from), std::min(x.to, y.to)};
      if (both.from < both.to) out.push_back(both);
    }
  return out;
}

TimeIntervals without(const TimeIntervals& a, const TimeIntervals& b) {
  TimeIntervals out;
  for (const auto& x : a) {
    double from = x.from;
    for (const auto& y : b) {
      if (y.to <= from || y.from >= x.to) continue;
      if (y.from > from) out.push_back({from, y.from});
      from = y.to;
    }
    if (from < x.to) out.push_back({from, x.to});
  }
  return out;
}

namespace {

// `tolerance` is that of the mean over the interval.
double integral(const std::function<double(double)>& f,
                const TimeInterval& interval,
                double tolerance,
                int depth = 0) {
  constexpr int kDeepest = 12;
  static const auto gauss = gauss_legendre(3);
  static const Quadrature lobatto{{0, 0.5, 1}, {1. / 6, 4. / 6, 1. / 6}};
  const double length = interval.to - interval.from;
  const auto mean = [&](const Quadrature& rule) {
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
      sum += rule.weights[i] * f(interval.from + length * rule.nodes[i]);
    return sum;
  };
  const double fine = mean(gauss);
  if (depth == kDeepest || std::fabs(mean(lobatto) - fine) <= tolerance) return fine * length;
  const double middle = (interval.from + interval.to) / 2;
  return integral(f, {interval.from, middle}, tolerance, depth + 1) +
         integral(f, {middle, interval.to}, tolerance, depth + 1);
}

}  // namespace

double integral(const std::function<double(double)>& f, const TimeInterval& interval) {
  // Both rules agree where they do not see what lies between their nodes, so no two are farther apart than
  // 0.4 / 8.
  constexpr int kParts = 8;
  constexpr double kTolerance = 1e-6;  // of the largest value
  const double length = (interval.to - interval.from) / kParts;
  double largest = 0;
  for (int i = 0; i <= kParts; ++i) largest = std::max(largest, std::fabs(f(interval.from + i * length)));
  double sum = 0;
  for (int i = 0; i < kParts; ++i)
    sum += integral(f, {interval.from + i * length, interval.from + (i + 1) * length}, kTolerance * largest);
  return sum;
}

}  // namespace orbs::analytic
