#pragma once

#include "scene/scene.h"

/// Meshes that a scene file asks for by name. Lengths are metres; y is up. Each function returns vertices
/// with unit normals and texture coordinates, tangents of zero, no name and no triangle_materials. Triangle
/// order is part of the contract, since scenes assign materials by it. Lengths must be positive; the scene
/// reader sees to that.
namespace orbs::scene {

struct PlaneParameters {
  double half_size_m = 1;
};
struct CubeParameters {
  double half_size_m = 1;
};
struct SphereParameters {
  double radius_m = 1;
  int segments = 64;  // around the equator; half as many bands from pole to pole
};
struct TorusParameters {
  double minor_radius_m = 0.25;  // of the tube
  double major_radius_m = 1;     // of the ring that the tube follows
  int ring_segments = 64;
  int tube_segments = 32;
};
struct TeapotParameters {
  int subdivisions = 20;  // of each patch, in both directions
};
struct TreeParameters {
  double height_m = 4;
  double radius_m = 1.2;  // of the lowest branches
  int tiers = 6;          // cones of branches, one above the other
  int points = 10;        // tips of the star that each tier is from above
};
struct WaterParameters {
  double half_width_m = 1;   // along x
  double half_length_m = 1;  // along z
  double depth_m = 1;        // from the mean surface, y = 0, down to the flat bottom
  double amplitude_m = 0.05;
  double wavelength_m = 1;  // of the longest wave
  int segments = 64;        // of the surface, in both directions
};

/// Triangles of the trunk, which come first; the rest is foliage.
inline constexpr int kTreeTrunkTriangles = 16;

/// How many triangles a generator will make of these parameters, which lie within what a scene file may say;
/// of a cube, the closed one.
constexpr std::size_t triangle_count(const PlaneParameters&) { return 2; }
constexpr std::size_t triangle_count(const CubeParameters&) { return 12; }
constexpr std::size_t triangle_count(const SphereParameters& p) {
  const auto segments = static_cast<std::size_t>(p.segments);
  return segments * segments;
}
constexpr std::size_t triangle_count(const TorusParameters& p) {
  return 2 * static_cast<std::size_t>(p.ring_segments) * static_cast<std::size_t>(p.tube_segments);
}
constexpr std::size_t triangle_count(const TeapotParameters& p) {
  const auto subdivisions = static_cast<std::size_t>(p.subdivisions);
  return 64 * subdivisions * subdivisions;
}
constexpr std::size_t triangle_count(const TreeParameters& p) {
  return kTreeTrunkTriangles + 4 * static_cast<std::size_t>(p.tiers) * static_cast<std::size_t>(p.points);
}
constexpr std::size_t triangle_count(const WaterParameters& p) {
  const auto segments = static_cast<std::size_t>(p.segments);
  return 2 * segments * segments + 12 * segments;
}

/// Square at y = 0, normal +Y, u along x and v along z in [0, 1]. Both triangles share the diagonal (-,-) ->
/// (+,+) and are wound against the normal.
Mesh make_plane(const PlaneParameters& parameters);

/// 24 vertices, faces in the order -Y +Y -Z +Z -X +X with two triangles each, wound counter-clockwise seen
/// from outside.
Mesh make_cube(const CubeParameters& parameters);

/// make_cube without its -Z face and with the normals turned inwards, the winding left as it is: 10
/// triangles, -Y +Y +Z -X +X.
Mesh make_cube_open(const CubeParameters& parameters);

/// segments^2 triangles, band after band from the north pole (+Y), so the first half is the northern
/// hemisphere; in the two polar bands every second triangle has no area. With i bands from the pole and j
/// segments from +Z towards +X: u = j / segments and v = (1 - i) / (segments - 1), which runs from just above
/// 0 to about -1/2. InputError when `segments` is odd.
Mesh make_sphere(const SphereParameters& parameters);

/// Ring in the XY plane, axis Z; 2 ring_segments tube_segments triangles ordered along the ring from +X
/// towards +Y. u runs around the tube, v along the ring.
Mesh make_torus(const TorusParameters& parameters);

/// The Utah teapot, spout along +X, 64 subdivisions^2 triangles: rim, body, lid and bottom (24 patches),
/// handle (4), spout (4). Uniformly scaled into x [-0.95239, 1.09017], y [-0.40505, 0.59507], z [-0.63493,
/// 0.63493]. Normals are those of the Bezier patches, by their limit at the knob's top and the bottom's
/// centre, where some triangles have no area. u and v are the parameters of each patch.
Mesh make_teapot(const TeapotParameters& parameters);

/// A fir with its foot in the origin: an open trunk, then from bottom to top `tiers` closed cones of 4 points
/// triangles each. Facets are flat: each triangle has vertices of its own. u runs around the trunk or cone, v
/// upwards, both in [0, 1].
Mesh make_tree(const TreeParameters& parameters);

/// A closed box of water whose top is wavy: three sine waves that together stay within +-amplitude about y =
/// 0. Normals of the top are those of the exact waves. 2 segments^2 triangles of the top, then 8 segments of
/// the sides, then 4 segments of the bottom. u along x and v along z in [0, 1].
Mesh make_water(const WaterParameters& parameters);

}  // namespace orbs::scene
