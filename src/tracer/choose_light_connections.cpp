#include "tracer/choose_light_connections.h"

#include "tracer/trial_image.h"
#include "tracer/world/build_world.h"

namespace orbs::tracer {

namespace {

constexpr int kSide = 32;  // pixels of the trial image's longer side
// A light path of one segment for each camera path, and one more shadow ray and two evaluations of BSDFs for
// each of its vertices take half as much time again to as much again, so the variance must fall by more.
constexpr double kWorthwhile = 0.45;

}  // namespace

bool choose_light_connections(World& world, int threads) {
  world.connects_light_vertices = false;
  if (!supports_light_connections(world)) return false;
  const Trial without = trial_of(world, kSide, threads);
  world.connects_light_vertices = true;
  const Trial with = trial_of(world, kSide, threads);
  const float exposure = exposure_of(with, without);
  world.connects_light_vertices = noise_of(with, exposure, 1) < kWorthwhile * noise_of(without, exposure, 1);
  return world.connects_light_vertices;
}

}  // namespace orbs::tracer
