#pragma once

#include "tracer/accel/user_geometry.h"
#include "tracer/geometry/render_object.h"

#include <array>

namespace orbs::tracer {

/// A disk or a sphere that an affine map has placed, as rays meet it: y = 0 within the unit circle, or the
/// unit sphere, in the local space of the shape.
struct CurvedSurface {
  Vec3d centre;
  std::array<Vec3d, 3> inverse_rows;  // of the linear part of the map
  bool is_sphere = false;
};

/// The inverse of a map by the images of the unit axes.
std::array<Vec3d, 3> inverse_rows(Vec3d a, Vec3d b, Vec3d c);

CurvedSurface surface_of(const SphereSurface& sphere);

/// For make_user_geometry. barycentric.x of a hit is what float leaves of the distance, so that both together
/// are the double.
UserBounds bounds_of(const CurvedSurface& surface);
std::optional<Hit> hit_of(const CurvedSurface& surface, unsigned int index, const UserRay& ray);

}  // namespace orbs::tracer
