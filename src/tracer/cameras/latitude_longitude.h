#pragma once

#include "base/in_double.h"
#include "tracer/cameras/film_ray.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbs::tracer {

/// All directions: x is the longitude over pi, y the latitude over pi / 2. `right` and `up` of the view are
/// unit.
struct LatitudeLongitude {};

template <typename View, typename Real>
FilmRay<Real> film_ray(const LatitudeLongitude&, const View& view, Real x, Real y) {
  const Real longitude = x * std::numbers::pi_v<Real>;
  const Real latitude = y * (std::numbers::pi_v<Real> / 2);
  return {view.position, (view.forward * in_double::cos(longitude) + view.right * in_double::sin(longitude)) *
                                 in_double::cos(latitude) +
                             view.up * in_double::sin(latitude)};
}

/// A solid angle is the cosine of the latitude times the measures of longitude and latitude.
template <typename View>
FilmPlace film_place(const LatitudeLongitude&, const View& view, Vec3f point) {
  constexpr float kHalfTurn = std::numbers::pi_v<float>;
  const Vec3f d = point - view.position;
  const float distance = length(d);
  if (!(distance > 0)) return {};
  const Vec3f flat{dot(d, view.right), dot(d, view.up), dot(d, view.forward)};
  const float level = in_double::hypot(flat.x, flat.z);
  return {in_double::atan2(flat.x, flat.z) / kHalfTurn, in_double::atan2(flat.y, level) / (kHalfTurn / 2),
          view.position, 2 * kHalfTurn * kHalfTurn, distance * level};  // r^2 cos(latitude)
}

}  // namespace orbs::tracer
