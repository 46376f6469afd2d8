#include "tracer/irradiance_cache/build_cache.h"

#include "base/parallel.h"
#include "base/random.h"
#include "scene/scene.h"
#include "tracer/geometry/transforms.h"
#include "tracer/irradiance_cache/candidates.h"
#include "tracer/irradiance_cache/hemisphere.h"
#include "tracer/irradiance_cache/visited_batch.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace orbs::tracer {

namespace {

// Separates their random numbers from those of camera paths.
constexpr std::uint64_t kRecordSeed = 0x4ec04d;

// Notes the length of the first ray of each path, and drops emission until a path has met a surface that is
// no delta function.
class RecordVisitor {
 public:
  explicit RecordVisitor(std::size_t paths) : distances_(paths, 0), is_direct_(paths, 1) {}

  void after_hit(CacheBatch& batch, std::uint32_t path, const Hit& hit) {
    if (distances_[path] == 0)
      distances_[path] = hit.object == kNoHit ? std::numeric_limits<float>::infinity() : hit.distance;
    if (is_direct_[path] != 0) batch.paths[path].radiance = {};
  }

  bool continues_at(CacheBatch&, std::uint32_t path, const CacheVertices& vertices, std::size_t lane) {
    if (!is_delta_at(vertices, lane)) is_direct_[path] = 0;
    return true;
  }

  float distance(std::size_t path) const { return distances_[path]; }

 private:
  std::vector<float> distances_;
  std::vector<std::uint8_t> is_direct_;  // seen from the record by delta functions alone
};

struct RecordPaths {
  std::vector<Sample> samples;
  CacheBatch batch;
};

// Paths whose rays start below the geometric surface do not become active: from there comes no light.
RecordPaths start_record_paths(const World& world,
                               const RenderSettings& settings,
                               const CacheCandidate& candidate,
                               const HemisphereStrata& strata) {
  RecordPaths out;
  const auto pixel =
      static_cast<std::uint32_t>(candidate.y) * static_cast<std::uint32_t>(world.camera.width) +
      static_cast<std::uint32_t>(candidate.x);
  const auto count = static_cast<std::uint32_t>(strata.count());
  const auto block =
      sample_block(mix(settings.seed, kRecordSeed), pixel, static_cast<std::uint32_t>(candidate.scatterings),
                   {settings.sampler, count});
  const Frame frame = frame_around(candidate.at.normal);
  out.batch.paths.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    out.samples.push_back({candidate.x, candidate.y, block, i});
    const auto u = draw(block, i, 0, SampleDimension::Scatter);
    const Vec3f direction = frame.to_world(direction_in_stratum(strata, i, {u[0], u[1]}));
    auto& path = out.batch.paths[i];
    path.sample = i;
    path.throughput = {1, 1, 1};
    path.scatterings = candidate.scatterings + 1;
    path.ray.origin = offset_origin(candidate.at.position, candidate.at.position_error,
                                    candidate.geometric_normal, direction);
    path.ray.direction = direction;
    if (sides_agree(candidate.geometric_normal, candidate.at.normal, direction))
      out.batch.active.push_back(i);
  }
  return out;
}

std::array<Vec3f, 3> to_world(const Frame& frame, const std::array<Vec3f, 3>& gradient) {
  return {frame.to_world(gradient[0]), frame.to_world(gradient[1]), frame.to_world(gradient[2])};
}

}  // namespace

ComputedRecord compute_record(const World& world,
                              const RenderSettings& settings,
                              const CacheCandidate& candidate) {
  const auto& cache = std::get<scene::IrradianceCache>(world.integrator);
  const HemisphereStrata strata = hemisphere_strata(cache.rays);
  auto paths = start_record_paths(world, settings, candidate, strata);
  RecordVisitor visitor(paths.samples.size());
  trace_visited(paths.batch, world, paths.samples, candidate.scatterings + 1, visitor);
  std::vector<IncomingLight> light(strata.count());
  for (std::size_t i = 0; i < light.size(); ++i) {
    // A path that did not start has a distance of zero: it sees nothing.
    if (visitor.distance(i) > 0) light[i] = {paths.batch.paths[i].radiance, visitor.distance(i)};
  }
  const HemisphereEstimate estimate = estimate_irradiance(strata, light);
  ComputedRecord out;
  out.traversal_seconds = paths.batch.traversal_seconds;
  IrradianceRecord& record = out.record;
  record.at = candidate.at;
  record.irradiance = estimate.irradiance;
  if (cache.has_gradients) {
    const Frame frame = frame_around(candidate.at.normal);
    record.translation_gradient = to_world(frame, estimate.translation_gradient);
    record.rotation_gradient = to_world(frame, estimate.rotation_gradient);
  }
  record.distance =
      cache.metric == scene::CacheMetric::Ward ? estimate.harmonic_mean_distance : estimate.least_distance;
  record.least_spacing = static_cast<float>(cache.least_spacing_px) * candidate.pixel_size;
  record.most_spacing = static_cast<float>(cache.most_spacing_px) * candidate.pixel_size;
  return out;
}

namespace {

// Pixels between the candidates of one pass.
constexpr std::array kStrides{16, 8, 4, 2, 1};
// Records of a group are computed without knowing of each other. Few keep it from computing twice what one of
// them covers; many keep threads busy.
constexpr std::size_t kGroup = 32;
// Each pass covers all candidates at its time, and clamping uncovers a few. A bound for the time alone: what
// is still uncovered is path traced.
constexpr int kMostRefills = 4;

using Indices = std::vector<std::size_t>;

class Builder {
 public:
  Builder(const World& world, const RenderSettings& settings)
      : world_(world), settings_(settings), candidates_(find_candidates(world, settings)) {
    make_caches();
  }

  IrradianceCaches build() {
    Indices left(candidates_.size());
    std::iota(left.begin(), left.end(), 0U);
    for (const int stride : kStrides) {
      const auto begins = std::stable_partition(left.begin(), left.end(), [&](std::size_t i) {
        return candidates_[i].x % stride != 0 || candidates_[i].y % stride != 0;
      });
      cover({begins, left.end()});
      left.erase(begins, left.end());
    }
    Indices all(candidates_.size());
    std::iota(all.begin(), all.end(), 0U);
    for (int refill = 0; refill < kMostRefills && cover(all); ++refill) {
    }
    return std::move(caches_);
  }

 private:
  std::size_t level(const CacheCandidate& candidate) const {
    return world_.trace_depth == scene::kUnlimitedDepth ? 0 : static_cast<std::size_t>(candidate.scatterings);
  }

  bool is_covered(std::size_t index) const {
    const CacheCandidate& candidate = candidates_[index];
    return caches_.of_scatterings[level(candidate)].covers(candidate.at);
  }

  // Camera samples lie within a pixel of the candidates; two are room for slanted surfaces.
  void make_caches() {
    constexpr float kMost = std::numeric_limits<float>::max();
    Vec3f low{kMost, kMost, kMost};
    Vec3f high = -low;
    std::size_t levels = 0;
    for (const CacheCandidate& candidate : candidates_) {
      const Vec3f p = candidate.at.position;
      const float margin = 2 * candidate.pixel_size;
      low = {std::min(low.x, p.x - margin), std::min(low.y, p.y - margin), std::min(low.z, p.z - margin)};
      high = {std::max(high.x, p.x + margin), std::max(high.y, p.y + margin), std::max(high.z, p.z + margin)};
      levels = std::max(levels, level(candidate) + 1);
    }
    caches_.of_scatterings.assign(
        levels, IrradianceCache(std::get<scene::IrradianceCache>(world_.integrator), low, high));
  }

  // Those of the candidates that no record covers, in an order that scatters them over the image, so that the
  // members of a group hardly cover each other.
  Indices uncovered(const Indices& indices) const {
    std::vector<std::uint8_t> has_cover(indices.size());
    constexpr std::size_t kSlice = 1024;
    const auto slices = static_cast<int>((indices.size() + kSlice - 1) / kSlice);
    for_each_index(slices, settings_.threads, [&](int slice) {
      const std::size_t from = static_cast<std::size_t>(slice) * kSlice;
      for (std::size_t i = from; i < std::min(indices.size(), from + kSlice); ++i)
        has_cover[i] = is_covered(indices[i]) ? 1 : 0;
    });
    std::vector<std::pair<std::uint64_t, std::size_t>> keyed;
    for (std::size_t i = 0; i < indices.size(); ++i)
      if (has_cover[i] == 0) keyed.emplace_back(mix(indices[i], settings_.seed), indices[i]);
    std::sort(keyed.begin(), keyed.end());
    Indices out;
    for (const auto& [key, index] : keyed) out.push_back(index);
    return out;
  }

  void add_group(std::span<const std::size_t> group) {
    std::array<ComputedRecord, kGroup> computed;
    for_each_index(static_cast<int>(group.size()), settings_.threads, [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      computed[at] = compute_record(world_, settings_, candidates_[group[at]]);
    });
    for (std::size_t i = 0; i < group.size(); ++i) {
      caches_.traversal_seconds += computed[i].traversal_seconds;
      if (!is_covered(group[i]))
        caches_.of_scatterings[level(candidates_[group[i]])].insert(computed[i].record);
    }
  }

  // False if all candidates had cover.
  bool cover(const Indices& indices) {
    const Indices missing = uncovered(indices);
    Indices group;
    for (const std::size_t index : missing) {
      if (is_covered(index)) continue;
      group.push_back(index);
      if (group.size() < kGroup) continue;
      add_group(group);
      group.clear();
    }
    if (!group.empty()) add_group(group);
    return !missing.empty();
  }

  const World& world_;
  const RenderSettings& settings_;
  std::vector<CacheCandidate> candidates_;
  IrradianceCaches caches_;
};

}  // namespace

std::size_t IrradianceCaches::record_count() const {
  std::size_t count = 0;
  for (const IrradianceCache& cache : of_scatterings) count += cache.records().size();
  return count;
}

const IrradianceCache* cache_for(const IrradianceCaches& caches, const World& world, int scatterings) {
  const auto level = world.trace_depth == scene::kUnlimitedDepth ? 0 : static_cast<std::size_t>(scatterings);
  return level < caches.of_scatterings.size() ? &caches.of_scatterings[level] : nullptr;
}

IrradianceCaches build_caches(const World& world, const RenderSettings& settings) {
  return Builder(world, settings).build();
}

}  // namespace orbs::tracer
