#pragma once

#include "analytic/form_factor.h"
#include "registry/analytic.h"

#include <functional>
#include <vector>

/// Polygons that move within their planes, their corners linear in time.
namespace orbs::analytic {

struct TimeInterval {
  double from = 0;
  double to = 0;
};
using TimeIntervals = std::vector<TimeInterval>;  // ascending, without overlap

Corners corners_at(const registry::FlatPolygon& polygon, double time);

/// When a point of its plane lies in the polygon. Exact: on which side of an edge the point lies changes at
/// the roots of a polynomial of second degree.
TimeIntervals times_inside(const registry::FlatPolygon& polygon, Vec3d point, const TimeInterval& within);

TimeIntervals common(const TimeIntervals& a, const TimeIntervals& b);
/// What is left of `a` without `b`.
TimeIntervals without(const TimeIntervals& a, const TimeIntervals& b);

/// The integral of a continuous function by adaptive quadrature, to about 1e-6 of its largest value, of what
/// lasts longer than a twentieth of the interval.
double integral(const std::function<double(double)>& f, const TimeInterval& interval);

}  // namespace orbs::analytic
