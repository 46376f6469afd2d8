#pragma once

#include "scene/scene.h"

namespace orbs::adapters::mitsuba {

/// The mesh in world space, each triangle with three separate vertices whose u grows along `axis` projected
/// into the triangle: Mitsuba's polariser transmits along the direction of u and absorbs along that of v.
scene::Mesh polariser_mesh(Vec3d axis, const scene::Mesh& mesh, const Mat4& place);

}  // namespace orbs::adapters::mitsuba
