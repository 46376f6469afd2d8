#include "tracer/irradiance_cache/render_irradiance_cache.h"

#include "base/parallel.h"
#include "tracer/irradiance_cache/build_cache.h"
#include "tracer/irradiance_cache/visited_batch.h"
#include "tracer/render/tile_samples.h"

#include <memory>
#include <mutex>
#include <vector>

namespace orbs::tracer {

namespace {

// What the path of a camera sample still looks for.
enum class PathStage : std::uint8_t {
  BeforeCache,   // only delta functions so far
  EmittersOnly,  // the cache was used: emitters by delta functions alone are left
  PathTraced     // the cache cannot be used: all light
};

class CacheVisitor {
 public:
  CacheVisitor(const World& world, const IrradianceCaches& caches) : world_(world), caches_(caches) {}

  void start(std::size_t paths) { stages_.assign(paths, PathStage::BeforeCache); }
  const CacheUse& use() const { return use_; }

  void after_hit(CacheBatch&, std::uint32_t, const Hit&) {}

  bool continues_at(CacheBatch& batch, std::uint32_t path, const CacheVertices& vertices, std::size_t lane) {
    PathStage& stage = stages_[path];
    if (stage == PathStage::PathTraced || is_delta_at(vertices, lane)) return true;
    if (stage == PathStage::EmittersOnly) return false;
    stage = adds_cached_light(batch, path, vertices, lane) ? PathStage::EmittersOnly : PathStage::PathTraced;
    return true;
  }

 private:
  bool adds_cached_light(CacheBatch& batch,
                         std::uint32_t index,
                         const CacheVertices& vertices,
                         std::size_t lane) {
    auto& path = batch.paths[index];
    const auto* bsdf = cached_bsdf(vertices, lane);
    // With one scattering left there is direct light alone.
    if (bsdf == nullptr || path.scatterings + 1 >= world_.trace_depth) return false;
    ++use_.lookups;
    const IrradianceCache* cache = cache_for(caches_, world_, path.scatterings);
    const auto found = cache == nullptr ? std::nullopt : cache->lookup(element_at(vertices, lane));
    if (!found) {
      ++use_.uncovered;
      return false;
    }
    if (found->was_negative) ++use_.negative;
    // A Lambertian surface reflects the radiance reflectance / pi * E.
    const Vec3f reflected = bsdf->reflectance * found->value * kInvPi;
    path.radiance += path.throughput * reflected;
    return true;
  }

  const World& world_;
  const IrradianceCaches& caches_;
  std::vector<PathStage> stages_;
  CacheUse use_;
};

class TileWorker {
 public:
  TileWorker(const World& world, const RenderSettings& settings, const IrradianceCaches& caches, Film& film)
      : world_(world), settings_(settings), film_(film), visitor_(world, caches) {}

  void trace(const Tile& tile, const Pass& pass) {
    trace_tile(tile, pass, settings_, film_, samples_, [&] { flush(); });
  }

  void report(Rendering& out) const {
    merge(out.bad_samples, bad_);
    out.traversal_seconds += batch_.traversal_seconds;
    out.cache_use.lookups += visitor_.use().lookups;
    out.cache_use.uncovered += visitor_.use().uncovered;
    out.cache_use.negative += visitor_.use().negative;
  }

 private:
  void flush() {
    if (samples_.empty()) return;
    start_paths(batch_, world_, samples_);
    visitor_.start(samples_.size());
    trace_visited(batch_, world_, samples_, 0, visitor_);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const Vec3f radiance = batch_.paths[i].radiance;
      if (is_finite(radiance))
        add_sample(film_.pixels[samples_[i].pixel], cast<double>(radiance));
      else
        merge(bad_, {1, samples_[i].x, samples_[i].y});
    }
    samples_.clear();
  }

  const World& world_;
  const RenderSettings& settings_;
  Film& film_;
  CacheVisitor visitor_;
  CacheBatch batch_;
  std::vector<Sample> samples_;
  BadSamples bad_;
};

}  // namespace

void render_irradiance_cache(const World& world,
                             const RenderSettings& settings,
                             const NumberedPass& pass,
                             Film& film,
                             Rendering& out,
                             const std::function<void()>& tile_done) {
  if (!out.irradiance_caches) {
    out.irradiance_caches = std::make_shared<const IrradianceCaches>(build_caches(world, settings));
    out.traversal_seconds += out.irradiance_caches->traversal_seconds;
    out.cache_use.records = out.irradiance_caches->record_count();
  }
  const IrradianceCaches& caches = *out.irradiance_caches;
  std::mutex mutex;
  for_each_index(tile_count(film), settings.threads, [&](int index) {
    TileWorker worker(world, settings, caches, film);
    worker.trace(tile_at(film, index), pass.pass);
    const std::lock_guard lock(mutex);
    worker.report(out);
    tile_done();
  });
}

}  // namespace orbs::tracer
