#include "tracer/irradiance_cache/compute_record.h"

#include "base/random.h"
#include "tracer/geometry/frame.h"
#include "tracer/irradiance_cache/hemisphere.h"
#include "tracer/irradiance_cache/visited_batch.h"

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

}  // namespace orbs::tracer
