#pragma once

#include "base/vec.h"

#include <optional>

namespace orbs::tracer {

/// A rectangle projected on the unit sphere around `from`, for uniform sampling by solid angle (Urena,
/// Fajardo, King 2013, "An Area-Preserving Parametrization for Spherical Rectangles").
struct SphericalRectangle {
  Vec3f from;
  Vec3f x;  // unit axes: along width, along length, and away from `from`
  Vec3f y;
  Vec3f z;
  float x0 = 0;
  float x1 = 0;
  float y0 = 0;
  float y1 = 0;
  float z0 = 0;  // negative distance of the plane
  float b0 = 0;
  float b1 = 0;
  float k = 0;
  float solid_angle = 0;
};

/// Of centre +- half_width +- half_length, at a right angle. Nothing if the solid angle is below 1e-2 sr,
/// where the sum of four angles minus 2 pi has fewer than four significant digits in float.
std::optional<SphericalRectangle> make_spherical_rectangle(Vec3f centre,
                                                           Vec3f half_width,
                                                           Vec3f half_length,
                                                           Vec3f from);

/// World position for (u, v) in [0, 1)^2.
Vec3f sample_point(const SphericalRectangle& rectangle, float u, float v);

}  // namespace orbs::tracer
