#pragma once

#include "tracer/light/emitter.h"

#include <optional>

namespace orbs::tracer {

/// A point on an emitter, sampled from the point `from`.
struct EmitterPoint {
  Vec3f position;
  Vec3f normal;   // unit, towards `from`
  float pdf = 0;  // per solid angle at `from`, without the selection of the emitter
  float position_error = 0;
};

/// Samples by solid angle where that reduces noise (spheres always, rectangles at short distance), else by
/// area; u and v in [0, 1). Nothing if `from` is on the dark side of the emitter.
std::optional<EmitterPoint> sample_towards(const EmitterShape& shape, Vec3f from, float u, float v);
std::optional<EmitterPoint> sample_towards(const TriangleEmitter& triangle,
                                           Vec3f from,
                                           Vec2f uv,
                                           Vec2f& texture_uv);

/// Pdf per solid angle at `from` with which sample_towards samples the point at `position`.
float pdf_towards(const EmitterShape& shape, Vec3f from, Vec3f position);

/// Radiance that the light emits from `position` towards `to`, with its IES profile; zero on the dark side.
Radiance radiance_towards(const AreaLight& light, Vec3f position, Vec3f to);

}  // namespace orbs::tracer
