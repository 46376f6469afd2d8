#include "tracer/choose_light.h"

#include "tracer/trial_image.h"
#include "tracer/world/build_world.h"

#include <utility>

namespace orbs::tracer {

namespace {

constexpr int kSelectionSide = 32;  // pixels of the trial image's longer side
// The tree takes a tenth to a third more time (scenes 201, 124 and 123 of ORB.S).
constexpr double kSelectionWorthwhile = 0.8;

}  // namespace

bool choose_light_selection(World& world, int threads) {
  if (world.light_bvh.empty()) return false;
  const Trial with = trial_of(world, kSelectionSide, threads);
  auto bvh = std::exchange(world.light_bvh, {});
  const Trial without = trial_of(world, kSelectionSide, threads);
  const float exposure = exposure_of(with, without);
  const bool worthwhile = noise_of(with, exposure, 1) < kSelectionWorthwhile * noise_of(without, exposure, 1);
  if (worthwhile) world.light_bvh = std::move(bvh);
  return worthwhile;
}

namespace {

constexpr int kPathsSide = 64;  // pixels of the trial image's longer side
// Light paths take a fifth to a half of the rendering time (measured on the mirror and glass scenes of
// ORB.S), so they must reduce noise by more.
constexpr double kPathsWorthwhile = 0.78;
// A caustic that camera paths find once in a thousand samples is practically absent from the pixels of a
// trial. Means over blocks of them represent pixels with 1024 samples, where it dominates the noise. Scenes
// without caustics have about the same block noise with and without light paths.
constexpr int kBlockSide = 8;
constexpr double kBlocksWorthwhile = 0.5;

// If the camera sees only a corner of what the emitters illuminate, hardly any light path contributes, and
// the trial shows no noise because it shows no light. It is believed from this many contributions per pixel
// on.
constexpr double kFewestContributions = 0.25;
// An exception is made if the camera paths miss more than this part of the light.
constexpr double kMostOfLightMissed = 0.5;

// If camera paths hardly ever find a caustic, or light by way of a wall, most pixels show neither light nor
// noise. The missing light is then an error like noise.
bool misses_most_light(const Trial& without, const Trial& with) {
  return light_of(without) < (1 - kMostOfLightMissed) * light_of(with);
}

bool are_paths_better(const Trial& with, const Trial& without) {
  if (misses_most_light(without, with)) return true;
  if (with.light_path_contributions < kFewestContributions) return false;
  const float exposure = exposure_of(with, without);
  return noise_of(with, exposure, 1) < kPathsWorthwhile * noise_of(without, exposure, 1) ||
         noise_of(with, exposure, kBlockSide) <
             kBlocksWorthwhile * (noise_of(without, exposure, kBlockSide) +
                                  squared_bias(without, with, exposure, kBlockSide));
}

}  // namespace

bool choose_light_paths(World& world, int threads) {
  if (world.caustic_casters.empty()) return false;
  const Trial with = trial_of(world, kPathsSide, threads);
  auto casters = std::exchange(world.caustic_casters, {});
  const Trial without = trial_of(world, kPathsSide, threads);
  const bool worthwhile = are_paths_better(with, without);
  if (worthwhile) world.caustic_casters = std::move(casters);
  return worthwhile;
}

namespace {

// Pixels of the trial image's longer side. The trial takes 0.09 CPU seconds; with 16 px it missed a scene in
// which connections take nine tenths of the variance.
constexpr int kConnectionsSide = 32;
// A light path of one segment for each camera path, and one more shadow ray and two evaluations of BSDFs for
// each of its vertices take as much time again, so the variance must fall by clearly more. On scene 101 of
// ORB.S it falls to 0.38, which gains nothing, and on "secondary" of Smits and Jensen's scenes to 0.03.
constexpr double kConnectionsWorthwhile = 0.25;

bool are_connections_better(const Trial& with, const Trial& without) {
  if (misses_most_light(without, with)) return true;
  const float exposure = exposure_of(with, without);
  return noise_of(with, exposure, 1) < kConnectionsWorthwhile * noise_of(without, exposure, 1);
}

}  // namespace

bool choose_light_connections(World& world, int threads) {
  world.connects_light_vertices = false;
  if (!supports_light_connections(world)) return false;
  const Trial without = trial_of(world, kConnectionsSide, threads);
  world.connects_light_vertices = true;
  const Trial with = trial_of(world, kConnectionsSide, threads);
  world.connects_light_vertices = are_connections_better(with, without);
  return world.connects_light_vertices;
}

}  // namespace orbs::tracer
