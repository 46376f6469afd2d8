#pragma once

#include "tracer/light/light_bounds.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

/// What trial light samples say of the nodes of a light BVH in the regions of a scene: above all, what is
/// blocked there.
namespace orbs::tracer {

/// Regions: cubes whose edge is a power of two about a fixed share of their distance from the eye, so that
/// they are about equally large in the image, each six times, for the main directions of the normal: the two
/// sides of a wall see different lights. What few samples of a region leave open is taken from a larger one.
struct RegionGrid {
  Vec3f eye;
  float cells_per_distance = 8;
};

enum class RegionSize : std::uint8_t { Small, Large };

/// A number that hardly two regions share; never zero.
std::uint64_t region_of(const RegionGrid& grid, const LightSampleContext& at, RegionSize size);

/// Factors of the importances of the nodes, one row for each region that has one, found by open addressing.
class LightFactors {
 public:
  LightFactors() = default;
  /// `rows` holds first the row of all regions that are not in `regions`, then one for each of these.
  LightFactors(const RegionGrid& grid,
               const std::vector<std::uint64_t>& regions,
               std::vector<float> rows,
               std::size_t nodes);

  bool empty() const { return rows_.empty(); }
  /// The row of the region, by node.
  const float* row_at(const LightSampleContext& at) const;
  std::size_t row_count() const { return nodes_ == 0 ? 0 : rows_.size() / nodes_; }
  const float* row(std::size_t number) const { return rows_.data() + number * nodes_; }

 private:
  std::uint32_t row_of(std::uint64_t region) const;

  RegionGrid grid_;
  std::size_t nodes_ = 0;
  std::vector<float> rows_;
  std::vector<std::uint64_t> keys_;    // a power of two of them; 0: free
  std::vector<std::uint32_t> row_of_;  // of each key
};

/// Sums of the trial samples, from which the factors result.
class LightSums {
 public:
  /// Of so many nodes, whose importances get factors.
  LightSums(const RegionGrid& grid, std::size_t nodes);

  /// The smallest region about the point whose sums are kept: those of the first few thousand are.
  std::size_t row_for(const LightSampleContext& at);
  /// What a sample of the node found in this region, as a share of what the node's importance promises.
  void add(std::size_t row, std::size_t node, float share);
  LightFactors factors() const;

 private:
  struct Sum {
    double squares = 0;
    std::uint32_t count = 0;
  };
  std::size_t row_for(const LightSampleContext& at, RegionSize size, std::size_t parent);
  double mean_square(std::size_t row, std::size_t node) const;

  RegionGrid grid_;
  std::size_t nodes_;
  std::unordered_map<std::uint64_t, std::size_t> row_of_;
  std::vector<std::uint64_t> regions_;  // of the rows from the second on
  std::vector<std::size_t> parents_;  // of all rows: that of the larger region, which counts its samples too
  std::vector<Sum> sums_;             // rows: first that of all regions together
};

}  // namespace orbs::tracer
