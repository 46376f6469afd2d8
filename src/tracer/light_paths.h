#pragma once

#include "tracer/film.h"
#include "tracer/world.h"

#include <cstdint>

namespace orbs::tracer {

/// A pass's worth of light paths: as many as the picture has pixels, times `samples_per_pixel`.
struct LightPass {
  std::uint64_t seed = 0;
  std::uint32_t number = 0;  // tells the passes of a render apart
  int samples_per_pixel = 0;
  int threads = 0;
};

struct LightPassResult {
  BadSamples bad_samples;
  double traversal_seconds = 0;
  std::uint64_t arrived = 0;  // contributions to pixels
};

/// Adds what the light paths bring to the current replicates of the film's pixels, in an order that does not
/// depend on the threads. Does nothing where the world has no light_path_targets.
LightPassResult add_light_paths(const World& world, const LightPass& pass, Film& film);

}  // namespace orbs::tracer
