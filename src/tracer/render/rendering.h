#pragma once

#include "image/image.h"
#include "tracer/render/film.h"
#include "tracer/sampling/sampler.h"

#include <cstdint>
#include <memory>

namespace orbs::tracer {

struct IrradianceCaches;

struct RenderSettings {
  int samples_per_pixel = 64;
  std::uint64_t seed = 1;
  int threads = 0;           // 0: all cores; the image does not depend on it
  bool split_paths = false;  // one layer per class of light path
  Sampler sampler = Sampler::Sobol;
  /// Of each pixel, at least; see plan_passes. Two give 0.73 of the squared error of four (ORB.S at 128 px
  /// and 16 samples), and their variance is unbiased. But it has one degree of freedom, and tests of two
  /// images of equal noise then call 1.8 % of right ones wrong instead of 0.1 %.
  int replicates = 4;
};

struct Progress {
  double done = 0;  // [0, 1]
  int samples_per_pixel = 0;
  double seconds = 0;
};

/// What the irradiance cache did; all zero without one.
struct CacheUse {
  std::uint64_t records = 0;
  std::uint64_t lookups = 0;    // by camera paths
  std::uint64_t uncovered = 0;  // of the lookups: no record could be used, and the path was traced on
  std::uint64_t negative = 0;   // of the lookups: a gradient led below zero, and the channel was set to zero
};

/// What trial renderings took; as in Rendering.
struct RenderTime {
  double seconds = 0;
  double cpu_seconds = 0;
  double traversal_seconds = 0;
};

inline void add(RenderTime& time, const RenderTime& more) {
  time.seconds += more.seconds;
  time.cpu_seconds += more.cpu_seconds;
  time.traversal_seconds += more.traversal_seconds;
}

struct Rendering {
  image::Image image;
  int samples_per_pixel = 0;  // fewer than in the settings after a stop
  double seconds = 0;         // wall clock of the rendering alone
  double cpu_seconds = 0;
  /// Inside the accelerator, summed over all threads; wall clock, so it grows when cores are shared.
  double traversal_seconds = 0;
  std::uint64_t light_path_contributions = 0;  // splats of light paths to pixels
  bool variance_leaves_floats = false;         // so the image has none, see float_holds_variances
  BadSamples bad_samples;
  CacheUse cache_use;
  std::shared_ptr<const IrradianceCaches> irradiance_caches;  // made by the first pass; else null
};

}  // namespace orbs::tracer
