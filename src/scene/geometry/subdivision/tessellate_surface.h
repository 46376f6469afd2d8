#pragma once

#include "scene/geometry/subdivision/half_edges.h"

#include <array>

namespace orbs::scene {

/// Triangles with their vertices on the limit surface. A vertex of the cage at a crease is several vertices
/// here, at one place and with one normal for each side.
struct SurfaceMesh {
  std::vector<Vec3d> places_m;
  std::vector<Vec3d> normals;  // unit, outwards
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Most steps: each takes four times as many triangles.
constexpr int kMostLevels = 10;

/// How many triangles tessellate() makes.
std::size_t triangle_count(const SubdivisionSurface& surface);

/// `levels` steps, 1 to kMostLevels, then all points moved to the limit. Each quadrilateral is two triangles,
/// as triangulate() makes them.
/// Between the vertices the triangles deviate from the surface by about (edge length)^2 / 8 times its
/// curvature, which falls fourfold with each level.
///
/// A displaced surface has the normals of its triangles, weighted by their angles at the vertex (Thürmer,
/// Wüthrich 1998); on both sides of a crease it moves along the mean of the normals, so that it stays closed.
///
/// InputError, without a place in a file, for what connect() refuses, a finite sharpness above `levels`, a
/// point without normal, and a displacement without finite value.
SurfaceMesh tessellate(const SubdivisionSurface& surface);

}  // namespace orbs::scene
