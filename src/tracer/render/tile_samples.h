#pragma once

#include "tracer/integrator/sample.h"
#include "tracer/render/passes.h"
#include "tracer/render/rendering.h"
#include "tracer/sampling/sampler.h"

#include <vector>

/// The camera samples of one tile and pass, in the order that every integrator with path batches takes.
namespace orbs::tracer {

/// Enough for full packets of rays, few enough that the state of a thread's paths stays in the L2 cache.
constexpr int kPathsPerBatch = 1024;

inline std::size_t pixel_index(const Film& film, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) + static_cast<std::size_t>(x);
}

/// Gathers the samples of whole pixels in `samples` and calls trace() before they become more than
/// kPathsPerBatch, and for the rest, if there is any; trace() adds them to the film and empties `samples`.
/// Ends the replicate of the tile's pixels where the pass does.
template <typename Trace>
void trace_tile(const Tile& tile,
                const Pass& pass,
                const RenderSettings& settings,
                Film& film,
                std::vector<Sample>& samples,
                Trace&& trace) {
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) {
      const auto block = sample_block(settings.seed, static_cast<std::uint32_t>(pixel_index(film, x, y)),
                                      pass.replicate, {settings.sampler, pass.length});
      for (std::uint32_t i = 0; i < pass.count; ++i) samples.push_back({x, y, block, pass.first + i});
      if (samples.size() + pass.count > kPathsPerBatch) trace();
    }
  if (!samples.empty()) trace();
  if (!pass.ends_replicate) return;
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) end_replicate(film.pixels[pixel_index(film, x, y)]);
}

}  // namespace orbs::tracer
