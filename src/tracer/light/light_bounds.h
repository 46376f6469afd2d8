#pragma once

#include "base/vec.h"

/// Bounds of the light that a group of emitters sends to a point, by which a light BVH selects them (Conty
/// Estevez and Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting").
namespace orbs::tracer {

/// Where light is to be sampled for. A zero normal stands for a point that light reaches from all sides: on
/// a surface that transmits, or mirrored in a plane.
struct LightSampleContext {
  Vec3f position;
  Vec3f normal;  // unit, on the side of the viewer
};

struct LightBounds {
  Vec3f low{};  // corners of the box around the emitters, in metres
  Vec3f high{};
  float radius = 0;  // of a sphere about the middle of the box that holds them too, in metres
  Vec3f axis{};      // unit; of the cone that holds all normals of the emitters
  /// Cosine of the cone's half angle; -1: normals in all directions.
  float cos_spread = -1;
  bool is_two_sided = false;
  /// Radiance times area as seen along the normal, in any unit that all emitters share.
  float power = 0;
};

inline Vec3f centre_of(const LightBounds& bounds) { return (bounds.low + bounds.high) * 0.5F; }

/// Bounds of both groups together.
LightBounds merged(const LightBounds& a, const LightBounds& b);

/// Estimate of the irradiance from the group, up to a common factor. It is zero only if no emitter of the
/// group can shine on the point; blockers are not known.
float importance(const LightBounds& bounds, const LightSampleContext& at);

}  // namespace orbs::tracer
