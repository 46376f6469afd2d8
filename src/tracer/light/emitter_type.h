#pragma once

#include "base/matrix.h"
#include "base/vec.h"
#include "tracer/light/light_bounds.h"

#include <cmath>
#include <concepts>
#include <optional>

/// A kind of emitter is how a kind of light (scene/lights) is sampled: a header and a source file of this
/// folder, and a line in the variant EmitterShape. Whatever its file lacks of the following is a compile
/// error:
///   XEmitter                          its shape in world space, with its `area`, prepared once per scene
///   make_emitter(scene::X, m, normal) prepares it; the normal is that of local -Y
///   surface_of(emitter)               what rays meet: a Quad, or a type with bounds_of and hit_of
///                                     (accel/user_geometry.h); not of one without an area
/// and the functions of EmitterType.
namespace orbs::tracer {

/// A point on an emitter, sampled from the point `from`.
struct EmitterPoint {
  Vec3f position;
  Vec3f normal;   // unit, towards `from`
  float pdf = 0;  // per solid angle at `from`, without the selection of the emitter
  float position_error = 0;
};

/// A point on an emitter from which a light path starts.
struct EmittingPoint {
  Vec3f position;
  Vec3f normal;        // unit, on the bright side
  float pdf_area = 0;  // per m^2, without the selection of the emitter
  float position_error = 0;
  Vec2f texture_uv;
};

/// sample_towards: by solid angle where that reduces noise, else by area; u and v in [0, 1). Nothing if
/// `from` is on the dark side. pdf_towards: per solid angle at `from` with which sample_towards samples the
/// point at `position`. point_on, pdf_area: as sample_towards and pdf_towards, of light paths. normal_of: at
/// a point of the surface. shows_bright_side: whether a viewer in that direction and distance from the point
/// sees the side that shines. rounding_of: bound of the rounding error of a point on the emitter, in metres.
/// bounds_of: for the light BVH; `power` is radiance times area. kHasArea: false for what no ray meets
/// (emitter_without_area.h). share_towards(emitter, direction): the share of what it emits that goes there,
/// of a kind that does not shine evenly.
template <typename Emitter>
concept EmitterType = requires(const Emitter& emitter, Vec3f at, float u) {
  { Emitter::kHasArea } -> std::convertible_to<bool>;
  { emitter.area } -> std::convertible_to<float>;
  { sample_towards(emitter, at, u, u) } -> std::same_as<std::optional<EmitterPoint>>;
  { pdf_towards(emitter, at, at) } -> std::same_as<float>;
  { point_on(emitter, u, u) } -> std::same_as<EmittingPoint>;
  { pdf_area(emitter, at) } -> std::same_as<float>;
  { normal_of(emitter, at) } -> std::same_as<Vec3f>;
  { shows_bright_side(emitter, at, at) } -> std::same_as<bool>;
  { rounding_of(emitter) } -> std::same_as<float>;
  { bounds_of(emitter, u) } -> std::same_as<LightBounds>;
};

/// Bound of the rounding error of a point interpolated from three vectors of this size, in metres (see
/// surface_point).
inline float rounding_of(Vec3f a, Vec3f b, Vec3f c) {
  return 16 * 0x1p-24F * (largest_magnitude(a) + largest_magnitude(b) + largest_magnitude(c));
}
inline float rounding_of(Vec3d a, Vec3d b, Vec3d c) {
  return 16 * 0x1p-24F *
         static_cast<float>(largest_magnitude(a) + largest_magnitude(b) + largest_magnitude(c));
}

/// Pdf per solid angle of a point sampled uniformly by area.
inline float area_to_solid_angle(Vec3f from, Vec3f position, Vec3f normal, float area) {
  const Vec3f d = position - from;
  const float distance2 = dot(d, d);
  const float cos_times_distance = std::abs(dot(normal, d));
  return distance2 * std::sqrt(distance2) / (cos_times_distance * area);
}

/// Nothing on the dark side.
inline std::optional<EmitterPoint> point_by_area(
    Vec3f from, Vec3f position, Vec3f normal, float area, float error) {
  if (dot(normal, from - position) <= 0) return std::nullopt;
  return EmitterPoint{position, normal, area_to_solid_angle(from, position, normal, area), error};
}

inline Vec3f root_of_squares(Vec3f a, Vec3f b, Vec3f c = {}) {
  const Vec3f sum = a * a + b * b + c * c;
  return {std::sqrt(sum.x), std::sqrt(sum.y), std::sqrt(sum.z)};
}

/// Bounds of an emitter with one normal, in a box of these half sizes.
inline LightBounds flat_bounds(Vec3f centre, Vec3f half, Vec3f normal, float power) {
  return {.low = centre - half,
          .high = centre + half,
          .radius = length(half),
          .axis = normal,
          .cos_spread = 1,
          .power = power};
}

}  // namespace orbs::tracer
