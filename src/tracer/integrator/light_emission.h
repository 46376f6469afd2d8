#pragma once

#include "tracer/geometry/ray.h"
#include "tracer/world/world.h"

#include <array>

/// Where light paths begin.
namespace orbs::tracer {

/// A ray from a point of an emitter towards the sharp surfaces of the world.
struct EmittedRay {
  Ray ray;
  std::size_t emitter = 0;
  Vec3f position;    // on the emitter
  Vec2f texture_uv;  // there, for emissive triangles
  float weight =
      0;  // cosine over all densities: choice of the emitter, area, solid angle; 0: into the dark side
};

/// `at`: point on the emitter and direction; `choice`: emitter, target, side of a triangle. All in [0, 1).
/// The world must have emitters and caustic_casters.
EmittedRay emit(const World& world, const std::array<float, 4>& at, const std::array<float, 4>& choice);

/// Radiance that the emitter sends along the ray that meets something at `target`.
Radiance emitted_towards(const World& world, const EmittedRay& emitted, Vec3f target);

}  // namespace orbs::tracer
