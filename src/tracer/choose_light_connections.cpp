#include "tracer/choose_light_connections.h"

#include "tracer/trial_image.h"
#include "tracer/world/build_world.h"

namespace orbs::tracer {

namespace {

// Pixels of the trial image's longer side. The trial takes 0.09 CPU seconds; with 16 px it missed a scene in
// which connections take nine tenths of the variance.
constexpr int kSide = 32;
// A light path of one segment for each camera path, and one more shadow ray and two evaluations of BSDFs for
// each of its vertices take as much time again, so the variance must fall by clearly more. On scene 101 of
// ORB.S it falls to 0.38, which gains nothing, and on "secondary" of Smits and Jensen's scenes to 0.03.
constexpr double kWorthwhile = 0.25;

// Light that camera paths hardly ever find makes no noise in a trial without connections, as it is missing.
// It is then an error like noise.
constexpr double kMostOfLightMissed = 0.5;

bool is_better(const Trial& with, const Trial& without) {
  if (light_of(without) < (1 - kMostOfLightMissed) * light_of(with)) return true;
  const float exposure = exposure_of(with, without);
  return noise_of(with, exposure, 1) < kWorthwhile * noise_of(without, exposure, 1);
}

}  // namespace

bool choose_light_connections(World& world, int threads) {
  world.connects_light_vertices = false;
  if (!supports_light_connections(world)) return false;
  const Trial without = trial_of(world, kSide, threads);
  world.connects_light_vertices = true;
  const Trial with = trial_of(world, kSide, threads);
  world.connects_light_vertices = is_better(with, without);
  return world.connects_light_vertices;
}

}  // namespace orbs::tracer
