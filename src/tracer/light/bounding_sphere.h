#pragma once

#include "base/vec.h"

/// Spheres towards which light paths are sent.
namespace orbs::tracer {

struct BoundingSphere {
  Vec3f centre;
  float radius = 0;
};

/// A direction from a point of an emitter with this unit normal towards the sphere: uniform over the cone
/// that it subtends, or cosine-weighted about the normal if `from` is inside. u and v in [0, 1).
Vec3f direction_towards(const BoundingSphere& sphere, Vec3f from, Vec3f normal, float u, float v);

/// Pdf per solid angle of such a direction. `was_chosen`: it was sampled towards this sphere, so rounding at
/// the rim of the cone cannot exclude it.
float pdf_towards(const BoundingSphere& sphere, Vec3f from, Vec3f normal, Vec3f direction, bool was_chosen);

/// The same for light that starts at a point without a normal: from inside uniform in all directions.
Vec3f direction_towards(const BoundingSphere& sphere, Vec3f from, float u, float v);
float pdf_towards(const BoundingSphere& sphere, Vec3f from, Vec3f direction, bool was_chosen);

}  // namespace orbs::tracer
