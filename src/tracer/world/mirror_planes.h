#pragma once

#include "base/vec.h"

#include <cmath>
#include <cstdint>
#include <vector>

/// Flat mirrors show lights at places that can be sampled like the lights themselves.
namespace orbs::tracer {

struct World;

struct MirrorPlane {
  Vec3f normal;      // unit, to the front
  float offset = 0;  // dot(normal, point of the plane)
};

inline float height_over(const MirrorPlane& plane, Vec3f point) {
  return dot(plane.normal, point) - plane.offset;
}

/// True before the plane by more than rounding: a point of a face that lies in the plane itself is not. It
/// says by which technique light is found, so nothing is lost where the bound is wider than rounding.
inline bool is_before(const MirrorPlane& plane, Vec3f point) {
  return height_over(plane, point) > 1e-4F * (1 + std::abs(plane.offset));
}

inline Vec3f mirrored(const MirrorPlane& plane, Vec3f point) {
  return point - plane.normal * (2 * height_over(plane, point));
}
inline Vec3f mirrored_direction(const MirrorPlane& plane, Vec3f direction) {
  return direction - plane.normal * (2 * dot(plane.normal, direction));
}

/// Finds the planes of all mirrors whose triangles are flat, in world.mirror_planes, and says per triangle of
/// a part which one it lies in (RenderObject::mirror_planes). None where there would be many: each is one of the
/// places between which a path has to choose. None with IES lights in point-area form, whose radiance depends
/// on where the light is going and not on its direction alone.
void find_mirror_planes(World& world);

/// The plane of the triangle, or -1.
int mirror_plane_of(const World& world, std::uint32_t object, std::uint32_t triangle);

/// How many planes have the point before them.
int planes_before(const std::vector<MirrorPlane>& planes, Vec3f point);

/// The n-th of those.
int plane_before(const std::vector<MirrorPlane>& planes, Vec3f point, int n);

}  // namespace orbs::tracer
