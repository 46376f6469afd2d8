#include "tracer/irradiance_cache/candidates.h"

#include "base/nth.h"
#include "base/parallel.h"
#include "base/random.h"
#include "tracer/irradiance_cache/visited_batch.h"

#include <utility>

namespace orbs::tracer {

namespace {

// Separates their random numbers from those of camera paths.
constexpr std::uint64_t kCandidateSeed = 0xca9d;

class CandidateVisitor {
 public:
  CandidateVisitor(const World& world, std::span<const Sample> samples)
      : world_(world), samples_(samples), travelled_(samples.size(), 0) {}

  void after_hit(CacheBatch&, std::uint32_t path, const Hit& hit) { travelled_[path] += hit.distance; }

  bool continues_at(CacheBatch& batch, std::uint32_t path, const CacheVertices& vertices, std::size_t lane) {
    if (is_delta_at(vertices, lane)) return true;
    const int scatterings = batch.paths[path].scatterings;
    // Interreflection needs one more scattering than direct light.
    if (cached_bsdf(vertices, lane) == nullptr || scatterings + 1 >= world_.trace_depth) return false;
    found_.push_back({element_at(vertices, lane), lane_of(vertices.geometric_normal, lane), samples_[path].x,
                      samples_[path].y, scatterings, pixel_width(world_.camera, travelled_[path])});
    return false;
  }

  std::vector<CacheCandidate> take() { return std::move(found_); }

 private:
  const World& world_;
  std::span<const Sample> samples_;
  std::vector<float> travelled_;  // by each path, in metres
  std::vector<CacheCandidate> found_;
};

std::vector<CacheCandidate> candidates_of_row(const World& world, const RenderSettings& settings, int y) {
  std::vector<Sample> samples;
  for (int x = 0; x < world.camera.width; ++x) {
    const auto pixel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(world.camera.width) +
                       static_cast<std::uint32_t>(x);
    samples.push_back(
        {x, y, sample_block(mix(settings.seed, kCandidateSeed), pixel, 0, {settings.sampler, 1}), 0});
  }
  CacheBatch batch;
  start_paths(batch, world, samples);
  for (const Sample& sample : samples)
    nth(batch.paths, sample.x).ray =
        camera_ray(world.camera, static_cast<float>(sample.x) + 0.5F, static_cast<float>(sample.y) + 0.5F);
  CandidateVisitor visitor(world, samples);
  trace_visited(batch, world, samples, 0, visitor);
  return visitor.take();
}

}  // namespace

std::vector<CacheCandidate> find_candidates(const World& world, const RenderSettings& settings) {
  std::vector<std::vector<CacheCandidate>> rows(static_cast<std::size_t>(world.camera.height));
  for_each_index(world.camera.height, settings.threads,
                 [&](int y) { nth(rows, y) = candidates_of_row(world, settings, y); });
  std::vector<CacheCandidate> all;
  for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
  return all;
}

}  // namespace orbs::tracer
