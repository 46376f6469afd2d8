#pragma once

#include "scene/geometry/mesh.h"

namespace orbs::scene {

struct PlaneParameters {
  double half_size_m = 1;
};
struct CubeParameters {
  double half_size_m = 1;
};

constexpr std::size_t triangle_count(const PlaneParameters&) { return 2; }
constexpr std::size_t triangle_count(const CubeParameters&) { return 12; }

/// Square at y = 0, normal +Y, u along x and v along z in [0, 1]. Both triangles share the diagonal (-,-) ->
/// (+,+) and are wound against the normal.
Mesh make_plane(const PlaneParameters& parameters);

/// 24 vertices, faces in the order -Y +Y -Z +Z -X +X with two triangles each, wound counter-clockwise seen
/// from outside.
Mesh make_cube(const CubeParameters& parameters);

/// make_cube without its -Z face and with the normals turned inwards, the winding left as it is: 10
/// triangles, -Y +Y +Z -X +X.
Mesh make_cube_open(const CubeParameters& parameters);

}  // namespace orbs::scene
