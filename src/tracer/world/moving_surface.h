#pragma once

#include "tracer/geometry/ray.h"
#include "tracer/geometry/render_object.h"
#include "tracer/geometry/surface_point.h"

namespace orbs::tracer {

/// The point where the ray hits an object, of this mesh, that moves or changes its shape, at the time of the
/// ray.
SurfacePoint point_on_moving_mesh(const RenderObject& object,
                                  const TriangleMesh& mesh,
                                  const Ray& ray,
                                  const Hit& hit);

}  // namespace orbs::tracer
