#pragma once

#include "base/vec.h"
#include "scene/scene.h"
#include "tracer/colour/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <variant>
#include <vector>

namespace orbs::tracer {

/// Parallelogram centre +- a +- b, emitting to the side of `normal`.
struct RectEmitter {
  Vec3f centre;
  Vec3f a;  // half the width
  Vec3f b;  // half the length
  Vec3f normal;
  float area = 0;
  bool is_orthogonal = false;
};

/// Ellipse centre + s a + t b with s^2 + t^2 <= 1, emitting to the side of `normal`.
struct DiskEmitter {
  Vec3f centre;
  Vec3f a;
  Vec3f b;
  Vec3f normal;
  float area = 0;
};

/// Image of the unit sphere under p -> centre + axes p: a sphere, or an ellipsoid when the light's matrix
/// says so.
struct SphereEmitter {
  Vec3f centre;
  std::array<Vec3f, 3> axes{};     // images of the unit axes
  std::array<Vec3f, 3> inverse{};  // rows of the inverse map
  float determinant = 1;           // |det axes|
  float area = 0;                  // of the sphere with the same volume: only steers selection
};

/// Triangle of an emissive mesh, emitting from both sides.
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
  Vec3f reflectance;  // of the bright side, by Lambert's law
  std::optional<scene::IesUse> ies;
  std::array<Vec3f, 3> ies_axes;  // unit world directions of the profile's local x, y, z
  Vec3f centre;
};

/// A point on an emitter as seen from `from`.
struct EmitterPoint {
  Vec3f position;
  Vec3f normal;   // unit, towards `from`
  float pdf = 0;  // per solid angle at `from`, without the choice of the emitter
  float position_error = 0;
};

/// Interpolation of a point from corners of this size in float, see surface_point.
inline float rounding_of(Vec3f a, Vec3f b, Vec3f c) {
  return 16 * 0x1p-24F * (largest_magnitude(a) + largest_magnitude(b) + largest_magnitude(c));
}
/// Of a point on the emitter.
inline float rounding_of(const RectEmitter& rect) { return rounding_of(rect.centre, rect.a, rect.b); }
inline float rounding_of(const DiskEmitter& disk) { return rounding_of(disk.centre, disk.a, disk.b); }
inline float rounding_of(const SphereEmitter& sphere) {
  return rounding_of(sphere.centre, sphere.axes[0] + sphere.axes[1], sphere.axes[2]);
}
inline float rounding_of(const TriangleEmitter& t) { return rounding_of(t.corner, t.edge1, t.edge2); }

/// Samples by solid angle where that is worth it (spheres always, rectangles at short distance), else by
/// area. Nothing when the emitter shows its dark side.
std::optional<EmitterPoint> sample_towards(const EmitterShape& shape, Vec3f from, float u, float v);
std::optional<EmitterPoint> sample_towards(const TriangleEmitter& triangle,
                                           Vec3f from,
                                           Vec2f uv,
                                           Vec2f& texture_uv);

/// Density per solid angle at `from` with which sample_towards picks the point at `position`.
float pdf_towards(const EmitterShape& shape, Vec3f from, Vec3f position);

/// Radiance that leaves the light at `position` towards `to`: zero on the dark side; IES profile applied.
Radiance radiance_towards(const AreaLight& light, Vec3f position, Vec3f to);

/// One table over all emitters: area lights first, then emissive triangles; chosen in proportion to power.
class EmitterTable {
 public:
  void build(const std::vector<float>& powers,
             std::vector<TriangleEmitter> triangles,
             std::size_t light_count);
  bool empty() const { return probability_.empty(); }
  std::size_t size() const { return probability_.size(); }
  std::size_t light_count() const { return light_count_; }
  /// Index for u in [0, 1): alias method (Walker 1977, Vose 1991).
  std::size_t pick(float u) const;
  /// Zero as well where no emitter has power: lamps of a spectrum that nobody sees.
  float probability(std::size_t emitter) const { return probability_.empty() ? 0 : probability_[emitter]; }
  const TriangleEmitter& triangle(std::size_t emitter) const { return triangles_[emitter - light_count_]; }

 private:
  std::size_t light_count_ = 0;
  std::vector<TriangleEmitter> triangles_;
  std::vector<float> probability_;
  std::vector<float> keep_;
  std::vector<std::uint32_t> alias_;
};

}  // namespace orbs::tracer
