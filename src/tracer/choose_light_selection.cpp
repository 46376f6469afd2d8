#include "tracer/choose_light_selection.h"

#include "tracer/trial_image.h"

#include <utility>

namespace orbs::tracer {

namespace {

constexpr int kSide = 32;  // pixels of the trial image's longer side
// The tree takes a tenth to a third more time (scenes 201, 124 and 123 of ORB.S).
constexpr double kWorthwhile = 0.8;

}  // namespace

bool choose_light_selection(World& world, int threads) {
  if (world.light_bvh.empty()) return false;
  const Trial with = trial_of(world, kSide, threads);
  auto bvh = std::exchange(world.light_bvh, {});
  const Trial without = trial_of(world, kSide, threads);
  const float exposure = exposure_of(with, without);
  const bool worthwhile = noise_of(with, exposure, 1) < kWorthwhile * noise_of(without, exposure, 1);
  if (worthwhile) world.light_bvh = std::move(bvh);
  return worthwhile;
}

}  // namespace orbs::tracer
