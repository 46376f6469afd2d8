#include "tracer/render.h"

#include "base/parallel.h"
#include "tracer/light_paths.h"
#include "tracer/trace_wave.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <ctime>
#include <mutex>

namespace orbs::tracer {

namespace {

constexpr int kTile = 16;       // pixels a side
constexpr int kReplicates = 4;  // fewest independent blocks that a picture's variance rests on
constexpr int kWave =
    1024;  // paths under way per thread: full packets, and their state stays in the L2 cache
constexpr int kSamplesPerPass = 32;  // between two looks at the stop flag

/// Samples [first, first + count) of replicate `replicate`.
struct Pass {
  std::uint32_t replicate = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool ends_replicate = false;
};

// Replicates are powers of two, the lengths at which the points are stratified, so that eight of them fit.
std::vector<Pass> plan_passes(int samples_per_pixel) {
  const auto wanted = static_cast<std::uint32_t>(samples_per_pixel);
  const std::uint32_t length = std::clamp(std::bit_floor(wanted / kReplicates), 1U, kBlock);
  std::vector<Pass> passes;
  for (std::uint32_t start = 0; start < wanted; start += length) {
    const std::uint32_t end = std::min(length, wanted - start);
    for (std::uint32_t first = 0; first < end; first += kSamplesPerPass) {
      const std::uint32_t count = std::min<std::uint32_t>(kSamplesPerPass, end - first);
      passes.push_back({start / length, first, count, first + count == end});
    }
  }
  return passes;
}

struct Tile {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
};

Tile tile_at(const Film& film, int index) {
  const int columns = (film.width + kTile - 1) / kTile;
  const int x0 = index % columns * kTile;
  const int y0 = index / columns * kTile;
  return {x0, y0, std::min(x0 + kTile, film.width), std::min(y0 + kTile, film.height)};
}

class TileWorker {
 public:
  TileWorker(const World& world, const RenderSettings& settings, Film& film)
      : world_(world), settings_(settings), film_(film) {
    wave_.split_paths = settings.split_paths;
  }

  void trace(const Tile& tile, const Pass& pass) {
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) {
        const auto block =
            sample_block(settings_.seed, static_cast<std::uint32_t>(pixel_index(x, y)), pass.replicate);
        for (std::uint32_t i = 0; i < pass.count; ++i) samples_.push_back({x, y, block, pass.first + i});
        if (samples_.size() + pass.count > kWave) flush();
      }
    flush();
    if (!pass.ends_replicate) return;
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) end_replicate(film_.pixels[pixel_index(x, y)]);
  }

  const BadSamples& bad_samples() const { return bad_; }
  double traversal_seconds() const { return wave_.traversal_seconds; }

 private:
  std::size_t pixel_index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(film_.width) + static_cast<std::size_t>(x);
  }

  void flush() {
    trace_wave<RgbTransport>(wave_, world_, samples_);
    std::vector<bool> is_bad(samples_.size(), false);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const Sample& sample = samples_[i];
      const Vec3f radiance = RgbTransport::to_rgb(wave_.paths[i].light, wave_.paths[i].lambda);
      is_bad[i] = !is_finite(radiance);
      if (is_bad[i])
        merge(bad_, {1, sample.x, sample.y});
      else
        add_sample(film_.pixels[pixel_index(sample.x, sample.y)], cast<double>(radiance));
    }
    for (const ClassedLight& part : wave_.classed) {
      if (is_bad[part.sample]) continue;
      const Sample& sample = samples_[part.sample];
      film_.class_sums[static_cast<std::size_t>(part.path_class)][pixel_index(sample.x, sample.y)] +=
          cast<double>(part.radiance);
    }
    samples_.clear();
  }

  const World& world_;
  const RenderSettings& settings_;
  Film& film_;
  Wave<RgbTransport> wave_;
  std::vector<Sample> samples_;
  BadSamples bad_;
};

double cpu_seconds_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Class sums exist for all classes while rendering; those that stayed black are no layers of the picture.
void drop_unused_classes(Film& film) {
  for (auto& sums : film.class_sums)
    if (std::all_of(sums.begin(), sums.end(), [](Vec3d v) { return v == Vec3d{}; })) sums.clear();
}

}  // namespace

Rendering render(const World& world,
                 const RenderSettings& settings,
                 const std::atomic<bool>& stop,
                 const std::function<void(const Progress&)>& report) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const double cpu_start = cpu_seconds_now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  Film film = make_film(world.camera.width, world.camera.height);
  if (settings.split_paths) film.class_sums.assign(PathClass::kCount, std::vector<Vec3d>(film.pixels.size()));
  const int tiles = ((film.width + kTile - 1) / kTile) * ((film.height + kTile - 1) / kTile);
  const auto passes = plan_passes(settings.samples_per_pixel);
  Rendering out;
  std::mutex mutex;
  for (std::size_t p = 0; p < passes.size() && !(stop && p > 0); ++p) {
    int tiles_done = 0;
    // First, because the tiles end the replicate that this pass belongs to.
    const auto light = add_light_paths(
        world,
        {settings.seed, static_cast<std::uint32_t>(p), static_cast<int>(passes[p].count), settings.threads},
        film);
    merge(out.bad_samples, light.bad_samples);
    out.traversal_seconds += light.traversal_seconds;
    out.arrived_light_paths += light.arrived;
    for_each_index(tiles, settings.threads, [&](int index) {
      TileWorker worker(world, settings, film);
      worker.trace(tile_at(film, index), passes[p]);
      const std::lock_guard lock(mutex);
      merge(out.bad_samples, worker.bad_samples());
      out.traversal_seconds += worker.traversal_seconds();
      const double done = (static_cast<double>(p) + static_cast<double>(++tiles_done) / tiles) /
                          static_cast<double>(passes.size());
      report({done, out.samples_per_pixel, seconds()});
    });
    out.samples_per_pixel += static_cast<int>(passes[p].count);
  }
  for (PixelSums& pixel : film.pixels) end_replicate(pixel);
  drop_unused_classes(film);
  out.picture = develop(film);
  out.seconds = seconds();
  out.cpu_seconds = cpu_seconds_now() - cpu_start;
  return out;
}

}  // namespace orbs::tracer
