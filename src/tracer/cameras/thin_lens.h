#pragma once

#include "tracer/cameras/pinhole.h"

namespace orbs::tracer {

/// A perspective from all points of a disk in the plane of the camera: each sees what the pinhole in the
/// middle sees on the plane at the distance of the focus, along the axis. From one of them it is a pinhole
/// whose window is shifted (camera.h, seen_through); here it is the one in the middle.
struct ThinLens {
  float radius = 0;
  float focus = 1;
};

template <typename View, typename Real>
FilmRay<Real> film_ray(const ThinLens&, const View& view, Real x, Real y) {
  return film_ray(Pinhole{}, view, x, y);
}

template <typename View>
FilmPlace film_place(const ThinLens&, const View& view, Vec3f point) {
  return film_place(Pinhole{}, view, point);
}

}  // namespace orbs::tracer
