#pragma once

#include "tracer/accel/user_geometry.h"
#include "tracer/geometry/render_object.h"

#include <array>
#include <optional>
#include <vector>

namespace orbs::tracer {

struct DoubleTriangle {
  std::array<Vec3d, 3> corners;
};

struct TriangleHit {
  double distance = 0;         // in units of the direction
  std::array<double, 2> uv{};  // barycentric weights of the second and the third corner
};

/// The point of the triangle, edges included, that lies on the ray with near < distance < far: the watertight
/// test of Woop, Benthin and Wald (2013, JCGT 2(1)), in double precision. Triangles that share an edge leave
/// no gap: each computes the same edge function but for its sign.
std::optional<TriangleHit> intersect(
    const DoubleTriangle& triangle, Vec3d origin, Vec3d direction, double near, double far);

/// The map of a point in double precision.
Vec3d to_world(const Affine& map, Vec3d p);

/// The triangles of a mesh in world space. One of no area by the arithmetic of its shading has three equal
/// corners, so that nothing hits it in double precision either.
std::vector<DoubleTriangle> world_triangles(const RenderObject& object, const TriangleMesh& mesh);

/// For make_user_geometry; hits are as Embree's own of a triangle mesh.
UserBounds bounds_of(const DoubleTriangle& triangle);
std::optional<Hit> hit_of(const DoubleTriangle& triangle, unsigned int index, const UserRay& ray);

}  // namespace orbs::tracer
