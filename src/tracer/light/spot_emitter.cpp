#include "tracer/light/spot_emitter.h"

namespace orbs::tracer {

SpotEmitter make_emitter(const scene::SpotShape& spot, const Mat4& matrix, Vec3d) {
  return {.position = cast<float>(transform_point(matrix, {})),
          .axis = normalised(transform_direction(matrix, {0, -1, 0})),
          .cos_inner = scene::cos_of_degrees(spot.inner_deg),
          .cos_outer = scene::cos_of_degrees(spot.outer_deg)};
}

std::optional<EmitterPoint> sample_towards(const SpotEmitter& spot, Vec3f from, float, float) {
  return sample_point(from, spot.position);
}

float share_towards(const SpotEmitter& spot, Vec3f to_viewer) {
  const double cosine = dot(spot.axis, normalised(cast<double>(to_viewer)));
  return static_cast<float>(scene::share_of_intensity(spot.cos_inner, spot.cos_outer, cosine));
}

// The directions with light are the cone about the axis, and importance() looks beyond a cone as if each
// direction in it were the normal of a surface: none with light is left out.
LightBounds bounds_of(const SpotEmitter& spot, float power) {
  LightBounds out = point_bounds(spot.position, power);
  out.axis = cast<float>(spot.axis);
  out.cos_spread = static_cast<float>(spot.cos_outer);
  return out;
}

}  // namespace orbs::tracer
