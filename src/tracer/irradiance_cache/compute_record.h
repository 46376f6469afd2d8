#pragma once

#include "tracer/irradiance_cache/candidates.h"

namespace orbs::tracer {

/// A record and the work that it took.
struct ComputedRecord {
  IrradianceRecord record;
  double traversal_seconds = 0;
};

/// Irradiance by interreflection at the place of the candidate, from paths of the path tracer: all light but
/// that which comes straight, or by delta functions alone, from emitters and the environment. The random
/// numbers depend on the seed, the pixel and the number of scatterings before.
ComputedRecord compute_record(const World& world,
                              const RenderSettings& settings,
                              const CacheCandidate& candidate);

}  // namespace orbs::tracer
