#pragma once

#include "tracer/light/emitter_type.h"

/// What emitters without an area have in common. No ray meets them, so that light sampling alone finds them
/// and has no other technique to be weighted against; light paths start at them by emission_without_area.h.
/// Their sample_towards returns a pdf by which what they emit is to be divided for the irradiance across the
/// direction: of a point the squared distance, of parallel light one.
namespace orbs::tracer {

template <typename Emitter>
concept EmitterWithoutArea = !Emitter::kHasArea;

float pdf_towards(const EmitterWithoutArea auto&, Vec3f, Vec3f) { return 0; }
EmittingPoint point_on(const EmitterWithoutArea auto&, float, float) { return {}; }
float pdf_area(const EmitterWithoutArea auto&, Vec3f) { return 0; }
Vec3f normal_of(const EmitterWithoutArea auto&, Vec3f) { return {}; }
bool shows_bright_side(const EmitterWithoutArea auto&, Vec3f, Vec3f) { return true; }
float rounding_of(const EmitterWithoutArea auto&) { return 0; }

/// Nothing at the point itself.
inline std::optional<EmitterPoint> sample_point(Vec3f from, Vec3f position) {
  const Vec3f to_viewer = from - position;
  const float distance2 = dot(to_viewer, to_viewer);
  if (!(distance2 > 0)) return std::nullopt;
  return EmitterPoint{position, to_viewer / std::sqrt(distance2), distance2, 0};
}

/// In all directions, with this intensity: an irradiance times a squared distance, which is the unit of a
/// radiance times an area.
inline LightBounds point_bounds(Vec3f position, float power) {
  return {.low = position, .high = position, .axis = {0, 0, 1}, .power = power};
}

}  // namespace orbs::tracer
