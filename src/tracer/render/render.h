#pragma once

#include "image/image.h"
#include "tracer/render/film.h"
#include "tracer/world/world.h"

#include <atomic>
#include <cstdint>
#include <functional>

namespace orbs::tracer {

struct RenderSettings {
  int samples_per_pixel = 64;
  std::uint64_t seed = 1;
  int threads = 0;           // 0: all cores; the image does not depend on it
  bool split_paths = false;  // one layer per class of light path
};

struct Progress {
  double done = 0;  // [0, 1]
  int samples_per_pixel = 0;
  double seconds = 0;
};

struct Rendering {
  image::Image image;
  int samples_per_pixel = 0;  // fewer than asked for after a stop
  double seconds = 0;         // wall clock of the rendering alone
  double cpu_seconds = 0;
  double traversal_seconds =
      0;  // of all threads, inside the accelerator; wall clock, so it grows when cores are shared
  std::uint64_t arrived_light_paths = 0;  // contributions that light paths made to pixels
  BadSamples bad_samples;
};

/// Renders in passes of a few samples over the whole image. `stop` ends it after the passes that are
/// complete (the first pass is always completed); `report` is called from one thread at a time.
Rendering render(const World& world,
                 const RenderSettings& settings,
                 const std::atomic<bool>& stop,
                 const std::function<void(const Progress&)>& report);

}  // namespace orbs::tracer
