#include "tracer/choose_light_paths.h"

#include "tracer/trial_image.h"

#include <utility>

namespace orbs::tracer {

namespace {

constexpr int kSide = 64;  // pixels of the trial image's longer side
// Light paths take a fifth to a half of the rendering time (measured on the mirror and glass scenes of
// ORB.S), so they must reduce noise by more.
constexpr double kWorthwhile = 0.78;
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

// If camera paths hardly ever find a caustic, most pixels show neither light nor noise. The missing light is
// then an error like noise.
bool is_better(const Trial& with, const Trial& without) {
  if (light_of(without) < (1 - kMostOfLightMissed) * light_of(with)) return true;
  if (with.light_path_contributions < kFewestContributions) return false;
  const float exposure = exposure_of(with, without);
  return noise_of(with, exposure, 1) < kWorthwhile * noise_of(without, exposure, 1) ||
         noise_of(with, exposure, kBlockSide) <
             kBlocksWorthwhile * (noise_of(without, exposure, kBlockSide) +
                                  squared_bias(without, with, exposure, kBlockSide));
}

}  // namespace

bool choose_light_paths(World& world, int threads) {
  if (world.caustic_casters.empty()) return false;
  const Trial with = trial_of(world, kSide, threads);
  auto casters = std::exchange(world.caustic_casters, {});
  const Trial without = trial_of(world, kSide, threads);
  const bool worthwhile = is_better(with, without);
  if (worthwhile) world.caustic_casters = std::move(casters);
  return worthwhile;
}

}  // namespace orbs::tracer
