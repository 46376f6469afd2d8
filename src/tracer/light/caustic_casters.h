#pragma once

#include "tracer/light/bounding_sphere.h"

#include <vector>

/// Near-specular surfaces towards which light paths are sent: camera paths rarely find the light of their
/// caustics.
namespace orbs::tracer {

/// Where a lobe scatters with a smaller pdf per solid angle (of its own sampling, from the camera), it counts
/// as its tail. Camera paths rarely sample the tail, and contribute much when they do; to a light path the
/// surface is about as dull as a diffuse one there, whose pdf is at most 1 / pi. The threshold does not
/// change the expected image. Noise is lowest between 1 and 5 (scene 248, where 1 takes 1.5 dB off the noise
/// of indirect light).
constexpr float kTailPdf = 1;

/// A direction towards the casters.
struct CasterDirection {
  Vec3f direction;  // unit
  float pdf = 0;    // per solid angle
};

/// Samples a direction from a point of an emitter with this unit normal towards one of the casters, each with
/// equal probability (direction_towards). `pick`, u and v in [0, 1). The pdf is that of the mixture.
/// `casters` must not be empty.
CasterDirection sample_towards_casters(
    const std::vector<BoundingSphere>& casters, Vec3f from, Vec3f normal, float pick, float u, float v);

}  // namespace orbs::tracer
