#pragma once

#include "base/vec.h"

#include <vector>

/// Where light paths are worth sending: towards surfaces that reflect or refract so sharply that a path from
/// the camera rarely finds the light through them.
namespace orbs::tracer {

struct World;
struct SurfaceMaterial;

struct BoundingSphere {
  Vec3f centre;
  float radius = 0;
};

/// True for mirrors, smooth glass, and GGX up to the roughness where next-event estimation does as well.
bool is_near_specular(const SurfaceMaterial& material);

/// In its tail a lobe scatters with less than this density per solid angle (of its own sampling, seen from
/// the camera). Camera paths rarely go there, and bring much light when they do; to a light path it is a
/// surface about as dull as a diffuse one, whose density is at most 1 / pi. Any number gives the same
/// image; its noise is the least between 1 and 5 (scene 248, where 1 takes 1.5 dB off that of indirect
/// light).
constexpr float kTailPdf = 1;

/// One sphere about the sharp triangles of each part; a single one about all where there would be many,
/// because each costs time per light path.
std::vector<BoundingSphere> find_caustic_casters(const World& world);

/// A direction from `from` towards the targets.
struct CasterDirection {
  Vec3f direction;  // unit
  float pdf = 0;    // per solid angle
};

/// From a point of an emitter with this unit normal: uniform over the cone that a target fills, or weighted
/// by the cosine about the normal where `from` lies within its sphere; each target with equal chance. `pick`,
/// u and v in [0, 1). The pdf is that of the mixture. `targets` must not be empty.
CasterDirection sample_towards_casters(
    const std::vector<BoundingSphere>& targets, Vec3f from, Vec3f normal, float pick, float u, float v);

}  // namespace orbs::tracer
