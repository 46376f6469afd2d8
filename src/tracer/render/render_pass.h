#pragma once

#include "base/nth.h"
#include "base/parallel.h"
#include "tracer/integrator/trace_batch.h"
#include "tracer/numeric_fault.h"
#include "tracer/render/light_pass.h"
#include "tracer/render/passes.h"
#include "tracer/render/rendering.h"
#include "tracer/render/tile_samples.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

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
    trace_tile(tile, pass, settings_, film_, samples_, [&] { flush(pass); });
  }

  const BadSamples& bad_samples() const { return bad_; }
  double traversal_seconds() const { return batch_.traversal_seconds; }

 private:
  void flush(const Pass& pass) {
    trace_batch<T>(batch_, world_, samples_);
    std::vector<bool> is_bad(samples_.size(), false);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const Sample& sample = samples_[i];
      is_bad[i] = !add(sample, batch_.paths[i]);
      if (const auto piece = piece_ended_by(pass, sample.index)) end_piece(film_, sample.pixel, *piece);
    }
    for (const ClassedRadiance& entry : batch_.classed) {
      if (is_bad[entry.sample]) continue;
      nth(film_.class_sums, entry.path_class)[samples_[entry.sample].pixel] += cast<double>(entry.radiance);
    }
    samples_.clear();
  }

  // False if the sample is not finite.
  bool add(const Sample& sample, const PathState<T>& path) {
    Vec3f radiance = T::to_rgb(path.radiance, path.lambda);
    constexpr float kMost = 10;
    if (has_fault(NumericFault::SamplesClamped))
      radiance = {std::min(radiance.x, kMost), std::min(radiance.y, kMost), std::min(radiance.z, kMost)};
    if (!is_finite(radiance)) {
      merge(bad_, {1, sample.x, sample.y});
      return false;
    }
    add_sample(film_.pixels[sample.pixel], cast<double>(radiance));
    if constexpr (T::kHasStokes)
      for (std::size_t k = 0; k < film_.stokes.size(); ++k)
        film_.stokes[k][sample.pixel] += cast<double>(T::stokes(path.radiance, k + 1, path.lambda));
    return true;
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
  // A worker's memory is taken once for many tiles.
  std::mutex mutex;
  std::vector<std::unique_ptr<TileWorker<T>>> resting;
  const auto next_worker = [&] {
    const std::lock_guard lock(mutex);
    if (resting.empty()) return std::make_unique<TileWorker<T>>(world, settings, film);
    auto worker = std::move(resting.back());
    resting.pop_back();
    return worker;
  };
  for_each_index(tile_count(film), settings.threads, [&](int index) {
    auto worker = next_worker();
    worker->trace(tile_at(film, index), pass.pass);
    const std::lock_guard lock(mutex);
    resting.push_back(std::move(worker));
    tile_done();
  });
  for (const auto& worker : resting) {
    merge(out.bad_samples, worker->bad_samples());
    out.traversal_seconds += worker->traversal_seconds();
  }
}

}  // namespace orbs::tracer
