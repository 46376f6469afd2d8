#pragma once

#include "tracer/irradiance_cache/record.h"
#include "tracer/irradiance_cache/record_octree.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace orbs::tracer {

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
