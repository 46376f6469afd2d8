#pragma once

#include "tracer/world/world.h"

#include <vector>

namespace orbs::tracer {

/// One sphere around the near-specular triangles of each object, or a single one around all if there would be
/// many, because each costs time per light path.
std::vector<BoundingSphere> find_caustic_casters(const World& world);

/// Fills world.mirror_planes with the planes of all mirrors whose triangles are flat, and
/// RenderObject::mirror_planes with the plane of each triangle. There are none if there would be many, as
/// every path has to choose between them, and none with IES lights in point-area form, whose radiance depends
/// on the target of the light and not on its direction alone.
void find_mirror_planes(World& world);

}  // namespace orbs::tracer
