#pragma once

#include "tracer/irradiance_cache/candidates.h"
#include "tracer/irradiance_cache/irradiance_cache.h"
#include "tracer/render/rendering.h"
#include "tracer/world/world.h"

#include <optional>
#include <vector>

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

/// The caches of an image. How much light a path still brings depends on how often it may scatter, so there
/// is one cache for each number of scatterings (mirrors, glass) before the surface; a single one for an
/// unlimited trace depth.
struct IrradianceCaches {
  std::vector<IrradianceCache> of_scatterings;
  double traversal_seconds = 0;  // of all record rays, summed over threads

  std::size_t record_count() const;
};

/// The cache for a path that has scattered so often, or null.
const IrradianceCache* cache_for(const IrradianceCaches& caches, const World& world, int scatterings);

/// Computes records until every candidate (candidates.h) is covered: on pixels from a coarse to a fine grid,
/// so that interpolation goes between records and not beyond them; then again where neighbour clamping has
/// uncovered places. Candidates are taken in a fixed order in groups of fixed size. The records of a group
/// are computed in parallel and inserted in that order, but for those that the group's earlier ones cover:
/// the caches do not depend on the number of threads. world.integrator must be an irradiance cache.
IrradianceCaches build_caches(const World& world, const RenderSettings& settings);

}  // namespace orbs::tracer
