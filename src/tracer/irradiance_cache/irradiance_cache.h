#pragma once

#include "base/vec.h"
#include "tracer/irradiance_cache/record.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace orbs::tracer {

/// Indices of records by place. A record lies in the nodes that its reach overlaps and that are hardly larger
/// than it is (Ward, Rubinstein and Clear 1988), so that a query descends a single path.
class RecordOctree {
 public:
  /// Bounds of the places that will be asked for; anywhere else nothing is found.
  RecordOctree(Vec3f low, Vec3f high);

  void insert(std::uint32_t record, Vec3f centre, float radius);

  /// Calls visit(record) for all records whose reach may hold the point, in an order that depends on the
  /// order of insertion alone.
  template <typename Visit>
  void for_each_at(Vec3f point, const Visit& visit) const {
    Cube cube = root_;
    if (!(largest_magnitude(point - cube.centre) <= cube.half_side)) return;
    for (std::uint32_t node = 0;;) {
      for (const std::uint32_t record : nodes_[node].records) visit(record);
      const std::size_t octant = octant_of(cube, point);
      node = nodes_[node].children[octant];
      if (node == 0) return;
      cube = child_of(cube, octant);
    }
  }

 private:
  struct Cube {
    Vec3f centre;
    float half_side = 0;
  };
  struct Node {
    std::array<std::uint32_t, 8> children{};  // 0: none; no node has the root as its child
    std::vector<std::uint32_t> records;
  };
  struct Ball {
    Vec3f centre;
    float radius = 0;
  };

  static std::size_t octant_of(const Cube& cube, Vec3f point) {
    return (point.x >= cube.centre.x ? 1U : 0U) + (point.y >= cube.centre.y ? 2U : 0U) +
           (point.z >= cube.centre.z ? 4U : 0U);
  }
  static Cube child_of(const Cube& cube, std::size_t octant) {
    const float quarter = cube.half_side / 2;
    const auto side = [&](std::size_t bit) { return (octant & bit) != 0 ? quarter : -quarter; };
    return {cube.centre + Vec3f{side(1), side(2), side(4)}, quarter};
  }
  void insert(std::uint32_t node, const Cube& cube, std::uint32_t record, const Ball& ball, int depth);

  Cube root_;
  std::vector<Node> nodes_;
};

/// Irradiance between the records: the weighted mean of what they extrapolate.
struct InterpolatedIrradiance {
  Vec3f value;
  bool was_negative = false;  // in a channel, which is 0 then: gradients may extrapolate below zero
};

/// Records that are interpolated (Ward, Rubinstein and Clear 1988). It depends on the order of insertion, so
/// its owner inserts from one thread. Queries change nothing.
class IrradianceCache {
 public:
  /// Bounds of the places that will be asked for; anywhere else no record is found.
  IrradianceCache(const scene::IrradianceCache& settings, Vec3f low, Vec3f high);

  /// Nothing where no record may be used.
  std::optional<InterpolatedIrradiance> lookup(const SurfaceElement& at) const;
  bool covers(const SurfaceElement& at) const;

  /// Limits the record's distance by its gradient, and its distance and those of others by each other:
  /// neighbour clamping, |R_i - R_j| <= |p_i - p_j| (Krivanek et al. 2006). What one record sees at distance
  /// R_j another sees no farther than R_j + |p_i - p_j|. Reaches of others may shrink, so that places lose
  /// their cover.
  void insert(IrradianceRecord record);

  const std::vector<IrradianceRecord>& records() const { return records_; }

 private:
  void clamp_to_neighbours(IrradianceRecord& record);

  scene::IrradianceCache settings_;
  RecordOctree octree_;
  std::vector<IrradianceRecord> records_;
};

}  // namespace orbs::tracer
