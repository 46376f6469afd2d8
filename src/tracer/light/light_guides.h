#pragma once

#include "tracer/light/bounding_sphere.h"

#include <cstddef>
#include <vector>

/// Which emitters send their light paths where, so that light vertices (integrator/light_vertex.h) lie where
/// they light what the camera sees. Learned from trial light paths (learn_light_guides.h).
namespace orbs::tracer {

struct LightGuide {
  std::size_t emitter = 0;
  BoundingSphere target;
  float probability = 0;  // of all light paths
};

/// Light paths that no guide sends: in proportion to power and cosine, so that no place is left out.
constexpr float kUnguidedShare = 0.25F;

/// What a trial light path brought.
struct GuideTrial {
  std::size_t emitter = 0;
  Vec3f position;  // of its light vertex
  float use = 0;   // share of the light of the points that the camera sees
};

/// Up to 16 guides with a probability of 1 - kUnguidedShare together, in order of their emitters. None if
/// fewer than four of the trials were of use.
std::vector<LightGuide> make_light_guides(const std::vector<GuideTrial>& trials);

/// A guide by its probability; null for a path that none sends. `u` in [0, 1).
const LightGuide* pick_guide(const std::vector<LightGuide>& guides, float u);

}  // namespace orbs::tracer
