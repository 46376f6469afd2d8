#pragma once

#include "tracer/cameras/film_ray.h"

namespace orbs::tracer {

/// Parallel rays from the plane of the camera.
struct Orthographic {};

template <typename View, typename Real>
FilmRay<Real> film_ray(const Orthographic&, const View& view, Real x, Real y) {
  return {view.position + view.right * x + view.up * y, view.forward};
}

template <typename View>
FilmPlace film_place(const Orthographic&, const View& view, Vec3f point) {
  const Vec3f d = point - view.position;
  const float depth = dot(d, view.forward);
  if (!(depth > 0)) return {};
  const float half_width = length(view.right);
  const float half_height = length(view.up);
  return {dot(d, view.right) / (half_width * half_width), dot(d, view.up) / (half_height * half_height),
          point - view.forward * depth, 4 * half_width * half_height, 1};
}

}  // namespace orbs::tracer
