#pragma once

#include "base/nth.h"
#include "base/parallel.h"
#include "base/random.h"
#include "tracer/integrator/trace_light_batch.h"
#include "tracer/render/film.h"

#include <algorithm>
#include <cstdint>

namespace orbs::tracer {

/// Light paths of one pass: proportional in number to the pixels times `samples_per_pixel`.
struct LightPass {
  std::uint64_t seed = 0;
  std::uint32_t number = 0;  // of the pass within the rendering
  int samples_per_pixel = 0;
  int threads = 0;
  Sampler sampler = Sampler::Sobol;
};

struct LightPassResult {
  BadSamples bad_samples;
  double traversal_seconds = 0;
  std::uint64_t contributions = 0;  // splats to pixels
};

constexpr std::uint32_t kLightPathsPerBatch = 1024;  // as for camera paths
constexpr std::uint64_t kLightSeed = 0x11947;  // separates their random numbers from those of camera paths
constexpr std::size_t kSamplesPerLightPath = 4;
constexpr int kChunksAtOnce = 256;  // whose splats wait in memory: those of about a million paths

/// The result of one block of jointly stratified paths, which is the unit of work: so the order of summation
/// is fixed.
struct LightChunk {
  std::vector<Splat> splats;
  double traversal_seconds = 0;
};

template <TracesFromLights T>
LightChunk trace_light_chunk(const World& world, SampleBlock block, std::uint32_t count) {
  LightPathBatch<T> batch;
  for (std::uint32_t first = 0; first < count; first += kLightPathsPerBatch)
    trace_light_batch<T>(batch, world, block, first, std::min(kLightPathsPerBatch, count - first));
  return {std::move(batch.splats), batch.traversal_seconds};
}

/// Adds the splats to their pixels. `share` converts the mean over the light paths into a sum over the camera
/// samples.
inline void add_splats(const std::vector<Splat>& splats, double share, Film& film, BadSamples& bad) {
  for (const Splat& splat : splats) {
    if (!is_finite(splat.value)) {
      merge(bad, {1, static_cast<int>(splat.pixel) % film.width, static_cast<int>(splat.pixel) / film.width});
      continue;
    }
    const Vec3d radiance = cast<double>(splat.value) * share;
    film.splats[splat.pixel] += radiance;
    if (!film.class_sums.empty()) nth(film.class_sums, splat.path_class)[splat.pixel] += radiance;
  }
}

/// Adds the contributions of light paths to the current pieces of the film's pixels, in an order that
/// does not depend on the number of threads. Does nothing if the world has no caustic_casters, or the film
/// takes no splats.
template <TracesFromLights T>
LightPassResult add_light_paths(const World& world, const LightPass& pass, Film& film) {
  LightPassResult result;
  if (world.caustic_casters.empty() || film.splats.empty()) return result;
  const auto samples = film.pixels.size() * static_cast<std::size_t>(pass.samples_per_pixel);
  const auto paths = (samples + kSamplesPerLightPath - 1) / kSamplesPerLightPath;
  const auto chunks = static_cast<int>((paths + kBlock - 1) / kBlock);
  const double share = static_cast<double>(pass.samples_per_pixel) / static_cast<double>(paths);
  std::vector<LightChunk> done(kChunksAtOnce);
  for (int first = 0; first < chunks; first += kChunksAtOnce) {
    const int count = std::min(kChunksAtOnce, chunks - first);
    for_each_index(count, pass.threads, [&](int i) {
      const auto chunk = static_cast<std::size_t>(first) + static_cast<std::size_t>(i);
      const auto left = static_cast<std::uint32_t>(std::min<std::size_t>(kBlock, paths - chunk * kBlock));
      const auto block = sample_block(mix(pass.seed, kLightSeed), static_cast<std::uint32_t>(chunk),
                                      pass.number, {pass.sampler, left});
      nth(done, i) = trace_light_chunk<T>(world, block, left);
    });
    for (int i = 0; i < count; ++i) {
      const LightChunk& chunk = nth(done, i);
      add_splats(chunk.splats, share, film, result.bad_samples);
      result.traversal_seconds += chunk.traversal_seconds;
      result.contributions += chunk.splats.size();
    }
  }
  return result;
}

}  // namespace orbs::tracer
