#pragma once

#include "base/vec.h"
#include "scene/scene.h"
#include "tracer/colour/colour.h"

#include <array>
#include <optional>
#include <variant>

/// Emitters: the area lights of the scene and the triangles of emissive meshes.
namespace orbs::tracer {

/// Parallelogram centre +- a +- b that emits to the side of `normal`.
struct RectEmitter {
  Vec3f centre;
  Vec3f a;  // half the width
  Vec3f b;  // half the length
  Vec3f normal;
  float area = 0;
  bool is_orthogonal = false;
};

/// Ellipse centre + s a + t b with s^2 + t^2 <= 1 that emits to the side of `normal`.
struct DiskEmitter {
  Vec3f centre;
  Vec3f a;
  Vec3f b;
  Vec3f normal;
  float area = 0;
};

/// Image of the unit sphere under p -> centre + axes p: a sphere, or an ellipsoid if the matrix of the light
/// scales unevenly.
struct SphereEmitter {
  Vec3f centre;
  std::array<Vec3f, 3> axes{};     // images of the unit axes
  std::array<Vec3f, 3> inverse{};  // rows of the inverse map
  float determinant = 1;           // |det axes|
  float area = 0;                  // of the sphere of equal volume; used for selection only
};

/// Triangle of an emissive mesh; emits from both sides.
struct TriangleEmitter {
  Vec3f corner;
  Vec3f edge1;
  Vec3f edge2;
  Vec3f normal;
  float area = 0;
  std::array<Vec2f, 3> uvs;
  int material = 0;
};

inline Vec2f interpolated_uv(const TriangleEmitter& t, Vec2f b) {
  return {t.uvs[0].x * (1 - b.x - b.y) + t.uvs[1].x * b.x + t.uvs[2].x * b.y,
          t.uvs[0].y * (1 - b.x - b.y) + t.uvs[1].y * b.x + t.uvs[2].y * b.y};
}

using EmitterShape = std::variant<RectEmitter, DiskEmitter, SphereEmitter>;

struct AreaLight {
  EmitterShape shape;
  Radiance radiance;
  Vec3f reflectance;  // Lambertian, of the emitting side
  std::optional<scene::IesUse> ies;
  std::array<Vec3f, 3> ies_axes;  // unit world directions of the profile's local x, y, z
  Vec3f centre;
};

/// Bound of the rounding error of a point interpolated from three vectors of this size, in metres (see
/// surface_point).
inline float rounding_of(Vec3f a, Vec3f b, Vec3f c) {
  return 16 * 0x1p-24F * (largest_magnitude(a) + largest_magnitude(b) + largest_magnitude(c));
}
/// The same for a point on the emitter.
inline float rounding_of(const RectEmitter& rect) { return rounding_of(rect.centre, rect.a, rect.b); }
inline float rounding_of(const DiskEmitter& disk) { return rounding_of(disk.centre, disk.a, disk.b); }
inline float rounding_of(const SphereEmitter& sphere) {
  return rounding_of(sphere.centre, sphere.axes[0] + sphere.axes[1], sphere.axes[2]);
}
inline float rounding_of(const TriangleEmitter& t) { return rounding_of(t.corner, t.edge1, t.edge2); }

}  // namespace orbs::tracer
