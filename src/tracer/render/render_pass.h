#pragma once

#include "base/nth.h"
#include "base/parallel.h"
#include "tracer/integrator/trace_batch.h"
#include "tracer/render/light_pass.h"
#include "tracer/render/passes.h"
#include "tracer/render/rendering.h"
#include "tracer/render/tile_samples.h"

#include <functional>
#include <mutex>

/// Rendering with one transport; src/tracer/kernels instantiates it.
namespace orbs::tracer {

/// Traces the samples of one tile.
template <Transport T>
class TileWorker {
 public:
  TileWorker(const World& world, const RenderSettings& settings, Film& film)
      : world_(world), settings_(settings), film_(film) {
    batch_.split_paths = settings.split_paths;
  }

  void trace(const Tile& tile, const Pass& pass) {
    trace_tile(tile, pass, settings_, film_, samples_, [&] { flush(); });
  }

  const BadSamples& bad_samples() const { return bad_; }
  double traversal_seconds() const { return batch_.traversal_seconds; }

 private:
  void flush() {
    trace_batch<T>(batch_, world_, samples_);
    std::vector<bool> is_bad(samples_.size(), false);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const Sample& sample = samples_[i];
      const PathState<T>& path = batch_.paths[i];
      const Vec3f radiance = T::to_rgb(path.radiance, path.lambda);
      const std::size_t pixel = sample.pixel;
      is_bad[i] = !is_finite(radiance);
      if (is_bad[i]) {
        merge(bad_, {1, sample.x, sample.y});
        continue;
      }
      add_sample(film_.pixels[pixel], cast<double>(radiance));
      if constexpr (T::kHasStokes)
        for (std::size_t k = 0; k < film_.stokes.size(); ++k)
          film_.stokes[k][pixel] += cast<double>(T::stokes(path.radiance, k + 1, path.lambda));
    }
    for (const ClassedRadiance& entry : batch_.classed) {
      if (is_bad[entry.sample]) continue;
      nth(film_.class_sums, entry.path_class)[samples_[entry.sample].pixel] += cast<double>(entry.radiance);
    }
    samples_.clear();
  }

  const World& world_;
  const RenderSettings& settings_;
  Film& film_;
  PathBatch<T> batch_;
  std::vector<Sample> samples_;
  BadSamples bad_;
};

/// Renders one pass over the whole film and adds its counts to `out`; `tile_done` is called from one thread
/// at a time.
template <Transport T>
void render_pass(const World& world,
                 const RenderSettings& settings,
                 const NumberedPass& pass,
                 Film& film,
                 Rendering& out,
                 const std::function<void()>& tile_done) {
  // Light paths come first, because the tiles end the piece that this pass belongs to.
  if constexpr (TracesFromLights<T>) {
    const auto light = add_light_paths<T>(
        world,
        {settings.seed, pass.number, static_cast<int>(pass.pass.count), settings.threads, settings.sampler},
        film);
    merge(out.bad_samples, light.bad_samples);
    out.traversal_seconds += light.traversal_seconds;
    out.light_path_contributions += light.contributions;
  }
  std::mutex mutex;
  for_each_index(tile_count(film), settings.threads, [&](int index) {
    TileWorker<T> worker(world, settings, film);
    worker.trace(tile_at(film, index), pass.pass);
    const std::lock_guard lock(mutex);
    merge(out.bad_samples, worker.bad_samples());
    out.traversal_seconds += worker.traversal_seconds();
    tile_done();
  });
}

}  // namespace orbs::tracer
