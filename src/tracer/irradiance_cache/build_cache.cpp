#include "tracer/irradiance_cache/build_cache.h"

#include "base/parallel.h"
#include "base/random.h"
#include "scene/scene.h"
#include "tracer/irradiance_cache/candidates.h"
#include "tracer/irradiance_cache/compute_record.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace orbs::tracer {

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
