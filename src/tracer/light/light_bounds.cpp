#include "tracer/light/light_bounds.h"

#include "base/in_double.h"
#include "tracer/sampling/warps.h"

#include <algorithm>
#include <cmath>

namespace orbs::tracer {

namespace {

// An angle in [0, pi].
struct Angle {
  float cosine = 1;
  float sine = 0;
};

Angle angle_of(float cosine) {
  const float c = std::clamp(cosine, -1.0F, 1.0F);  // dot products of unit vectors, rounded
  return {c, std::sqrt(1 - c * c)};
}

// max(0, a - b).
Angle reduced(Angle a, Angle b) {
  if (a.cosine >= b.cosine) return {};
  return {a.cosine * b.cosine + a.sine * b.sine, std::max(0.0F, a.sine * b.cosine - a.cosine * b.sine)};
}

Vec3f smaller(Vec3f a, Vec3f b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3f larger(Vec3f a, Vec3f b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

// The smallest cone around two cones: its half angle is half of both and the angle between their axes.
void merge_cones(const LightBounds& a, const LightBounds& b, LightBounds& out) {
  const Vec3f b_axis = out.is_two_sided && dot(a.axis, b.axis) < 0 ? -b.axis : b.axis;
  const LightBounds& wide = a.cos_spread <= b.cos_spread ? a : b;
  const Vec3f wide_axis = a.cos_spread <= b.cos_spread ? a.axis : b_axis;
  const Vec3f narrow_axis = a.cos_spread <= b.cos_spread ? b_axis : a.axis;
  const float wide_angle = in_double::acos(std::clamp(wide.cos_spread, -1.0F, 1.0F));
  const float narrow_angle = in_double::acos(std::clamp(std::max(a.cos_spread, b.cos_spread), -1.0F, 1.0F));
  const float between = in_double::acos(std::clamp(dot(wide_axis, narrow_axis), -1.0F, 1.0F));
  out.axis = wide_axis;
  out.cos_spread = wide.cos_spread;
  if (between + narrow_angle <= wide_angle) return;
  const float half = (wide_angle + narrow_angle + between) / 2;
  const Vec3f across = narrow_axis - wide_axis * dot(wide_axis, narrow_axis);
  if (half >= kPi || !(dot(across, across) > 0)) {
    out.cos_spread = -1;
    return;
  }
  const float turn = half - wide_angle;
  out.axis = normalised(wide_axis * in_double::cos(turn) + normalised(across) * in_double::sin(turn));
  out.cos_spread = in_double::cos(half);
}

// No point of the box has a greater dot product with the normal, seen from `from`.
float highest(const LightBounds& bounds, Vec3f normal, Vec3f from) {
  const Vec3f half = (bounds.high - bounds.low) * 0.5F;
  return dot(normal, centre_of(bounds) - from) + std::abs(normal.x) * half.x + std::abs(normal.y) * half.y +
         std::abs(normal.z) * half.z;
}

// The box lies below the horizon of the point, or the point below that of every emitter in it. The cosines of
// importance() do not tell: the sphere about a wide lamp reaches below a horizon that the lamp does not, and
// within the sphere no direction is known.
bool is_beyond_horizon(const LightBounds& bounds, const LightSampleContext& at) {
  if (!(at.normal == Vec3f{}) && !(highest(bounds, at.normal, at.position) > 0)) return true;
  const bool is_flat = bounds.cos_spread >= 1 && !bounds.is_two_sided;
  return is_flat && !(highest(bounds, -bounds.axis, at.position) > 0);
}

}  // namespace

LightBounds merged(const LightBounds& a, const LightBounds& b) {
  LightBounds out{.low = smaller(a.low, b.low),
                  .high = larger(a.high, b.high),
                  .is_two_sided = a.is_two_sided || b.is_two_sided,
                  .power = a.power + b.power};
  const Vec3f diagonal = out.high - out.low;
  const auto reach = [&](const LightBounds& part) {
    return length(centre_of(part) - centre_of(out)) + part.radius;
  };
  out.radius = std::min(length(diagonal) / 2, std::max(reach(a), reach(b)));
  merge_cones(a, b, out);
  return out;
}

float importance(const LightBounds& bounds, const LightSampleContext& at) {
  if (is_beyond_horizon(bounds, at)) return 0;
  const Vec3f to_light = centre_of(bounds) - at.position;
  const float radius2 = bounds.radius * bounds.radius;
  const float distance2 = dot(to_light, to_light);
  // Inside the sphere the distance and all directions are unknown.
  if (!(distance2 > radius2)) return bounds.power / std::max(radius2, 0x1p-100F);
  const Vec3f direction = to_light / std::sqrt(distance2);
  const Angle subtended = angle_of(std::sqrt(1 - radius2 / distance2));
  float weight = bounds.power / distance2;
  if (bounds.cos_spread > -1) {
    const float cosine = -dot(bounds.axis, direction);
    const Angle off_axis = angle_of(bounds.is_two_sided ? std::abs(cosine) : cosine);
    weight *= std::max(0.0F, reduced(reduced(off_axis, angle_of(bounds.cos_spread)), subtended).cosine);
  }
  if (!(at.normal == Vec3f{}))
    weight *= std::max(0.0F, reduced(angle_of(dot(at.normal, direction)), subtended).cosine);
  return weight;
}

}  // namespace orbs::tracer
