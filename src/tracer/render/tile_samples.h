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

/// Gathers the samples of whole pixels in `samples` and calls trace() before they become more than
/// kPathsPerBatch, and for the rest, if there is any; trace() adds them to the film and empties `samples`.
template <typename Trace>
void trace_tile(const Tile& tile,
                const Pass& pass,
                const RenderSettings& settings,
                Film& film,
                std::vector<Sample>& samples,
                Trace&& trace) {
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) {
      const auto pixel = static_cast<std::uint32_t>(pixel_index(film, x, y));
      const auto [camera_x, camera_y] = camera_pixel(film, pixel, x, y);
      const auto block = sample_block(settings.seed, pixel, pass.block, {settings.sampler, pass.length});
      for (std::uint32_t i = 0; i < pass.count; ++i)
        samples.push_back({camera_x, camera_y, block, pass.first + i, pixel});
      if (samples.size() + pass.count > kPathsPerBatch) trace();
    }
  if (!samples.empty()) trace();
}

}  // namespace orbs::tracer
