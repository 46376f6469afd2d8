#include "tracer/light/light_factors.h"

#include "base/random.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace orbs::tracer {

namespace {

// Bounds the memory: with 255 nodes, 33 MB while sums are taken and 8 MB afterwards.
constexpr std::size_t kMostRegions = 8192;

// A region knows a node by its own samples from about this many on, and before by those of the larger one.
constexpr double kPriorSamples = 4;
// A share that is much greater than one comes of an importance that is much too low near an emitter. Few such
// samples must not decide.
constexpr float kMostShare = 8;
// No node loses more than this, however many samples found it blocked: light through a slit that none of
// them found is not left to the few that the slit would then get.
constexpr float kLeastFactor = 0x1p-5F;

std::uint64_t side_of(Vec3f normal) {
  if (normal == Vec3f{}) return 6;
  const std::array size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  const auto axis = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  return 2 * axis + (std::array{normal.x, normal.y, normal.z}[axis] < 0 ? 1 : 0);
}

std::uint64_t cell(float coordinate, float size) {
  constexpr float kMost = 0x1p30F;
  return static_cast<std::uint32_t>(
      static_cast<std::int32_t>(std::clamp(std::floor(coordinate / size), -kMost, kMost)));
}

}  // namespace

std::uint64_t region_of(const RegionGrid& grid, const LightSampleContext& at, RegionSize size) {
  constexpr int kLargerBy = 2;  // powers of two
  const float distance = std::max(length(at.position - grid.eye), 0x1p-60F);
  const bool is_large = size == RegionSize::Large;
  const int exponent = std::ilogb(distance / grid.cells_per_distance) + (is_large ? kLargerBy : 0);
  const float edge = std::ldexp(1.0F, exponent);
  const std::uint64_t x = cell(at.position.x, edge);
  const std::uint64_t y = cell(at.position.y, edge);
  const std::uint64_t z = cell(at.position.z, edge);
  const auto level = static_cast<std::uint64_t>(exponent + 1024) << 1 | (is_large ? 1 : 0);
  return std::max<std::uint64_t>(1, mix(mix(x << 32 | y, z), level << 3 | side_of(at.normal)));
}

LightFactors::LightFactors(const RegionGrid& grid,
                           const std::vector<std::uint64_t>& regions,
                           std::vector<float> rows,
                           std::size_t nodes)
    : grid_(grid), nodes_(nodes), rows_(std::move(rows)) {
  // At most half full, so that a search is short.
  keys_.assign(std::bit_ceil(2 * regions.size() + 1), 0);
  row_of_.assign(keys_.size(), 0);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    std::size_t slot = regions[i] & (keys_.size() - 1);
    while (keys_[slot] != 0) slot = (slot + 1) & (keys_.size() - 1);
    keys_[slot] = regions[i];
    row_of_[slot] = static_cast<std::uint32_t>(i + 1);
  }
}

std::uint32_t LightFactors::row_of(std::uint64_t region) const {
  std::size_t slot = region & (keys_.size() - 1);
  while (keys_[slot] != 0 && keys_[slot] != region) slot = (slot + 1) & (keys_.size() - 1);
  return row_of_[slot];
}

const float* LightFactors::row_at(const LightSampleContext& at) const {
  const std::uint32_t small = row_of(region_of(grid_, at, RegionSize::Small));
  return row(small != 0 ? small : row_of(region_of(grid_, at, RegionSize::Large)));
}

LightSums::LightSums(const RegionGrid& grid, std::size_t nodes)
    : grid_(grid), nodes_(nodes), parents_(1), sums_(nodes) {}

std::size_t LightSums::row_for(const LightSampleContext& at) {
  return row_for(at, RegionSize::Small, row_for(at, RegionSize::Large, 0));
}

std::size_t LightSums::row_for(const LightSampleContext& at, RegionSize size, std::size_t parent) {
  const std::uint64_t region = region_of(grid_, at, size);
  const auto found = row_of_.find(region);
  if (found != row_of_.end()) return found->second;
  if (regions_.size() == kMostRegions) return parent;
  regions_.push_back(region);
  parents_.push_back(parent);
  sums_.resize(sums_.size() + nodes_);
  return row_of_[region] = regions_.size();
}

void LightSums::add(std::size_t row, std::size_t node, float share) {
  const double bounded = std::min(share, kMostShare);
  const double square = bounded * bounded;
  for (;; row = parents_[row]) {
    Sum& sum = sums_[row * nodes_ + node];
    sum.squares += square;
    ++sum.count;
    if (row == 0) return;
  }
}

double LightSums::mean_square(std::size_t row, std::size_t node) const {
  const Sum& sum = sums_[row * nodes_ + node];
  if (row == 0) return (sum.squares + 1) / (sum.count + 1.0);
  return (sum.squares + kPriorSamples * mean_square(parents_[row], node)) / (sum.count + kPriorSamples);
}

// The variance of a choice between two estimators is least if each is chosen in proportion to the root of its
// second moment.
LightFactors LightSums::factors() const {
  std::vector<float> rows(sums_.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = std::max(kLeastFactor, static_cast<float>(std::sqrt(mean_square(i / nodes_, i % nodes_))));
  return {grid_, regions_, std::move(rows), nodes_};
}

}  // namespace orbs::tracer
