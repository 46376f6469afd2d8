#pragma once

#include "tracer/cameras/film_ray.h"

namespace orbs::tracer {

/// A perspective through one point. Where its window is shifted, `centre` of the view is not `forward`.
struct Pinhole {};

template <typename View, typename Real>
FilmRay<Real> film_ray(const Pinhole&, const View& view, Real x, Real y) {
  return {view.position, view.centre + view.right * x + view.up * y};
}

/// A surface element dA at distance r, perpendicular to the ray, subtends dA / r^2, which projects to
/// dA / (r^2 cos^3) on the image plane at distance 1. The pixel averages over its own area of that plane.
template <typename View>
FilmPlace film_place(const Pinhole&, const View& view, Vec3f point) {
  const Vec3f d = point - view.position;
  const float depth = dot(d, view.forward);
  if (!(depth > 0)) return {};
  const Vec3f on_plane = d / depth - (view.centre - view.forward);
  const float half_width = length(view.right);
  const float half_height = length(view.up);
  const float distance = length(d);
  const float cosine = depth / distance;
  return {dot(on_plane, view.right) / (half_width * half_width),
          dot(on_plane, view.up) / (half_height * half_height), view.position, 4 * half_width * half_height,
          distance * distance * cosine * cosine * cosine};
}

}  // namespace orbs::tracer
