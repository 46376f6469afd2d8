#include "tracer_cli/stamp.h"

#include "base/files.h"
#include "scene/effects/effects.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::tracer_cli {

namespace {

void stamp_cache(tracer::Rendering& rendering, const scene::IrradianceCache& cache) {
  auto& header = rendering.image.attributes;
  const bool is_ward = cache.metric == scene::CacheMetric::Ward;
  header["orbs.integrator"] = "irradiance_cache";
  header["orbs.biased"] = "irradiance cache";
  header["orbs.variance"] = "left out: an irradiance cache is biased, and its pixels err together";
  header["orbs.cache_metric"] = is_ward ? fmt::format("ward, error {}", cache.error)
                                        : fmt::format("tabellion_lamorlette, kappa {}", cache.kappa);
  header["orbs.cache_rays"] = std::to_string(cache.rays);
  header["orbs.cache_records"] = std::to_string(rendering.cache_use.records);
  header["orbs.cache_lookups"] = std::to_string(rendering.cache_use.lookups);
  header["orbs.cache_uncovered"] = std::to_string(rendering.cache_use.uncovered);
  header["orbs.cache_negative"] = std::to_string(rendering.cache_use.negative);
}

}  // namespace

void stamp(tracer::Rendering& rendering,
           const Options& options,
           const scene::Scene& scene,
           const tracer::World& world,
           const std::string& version) {
  auto& header = rendering.image.attributes;
  header["orbs.program"] = "orbs-tracer";
  header["orbs.version"] = version;
  header["orbs.scene"] = scene.name;
  header["orbs.scene_hash"] = hash_text(content_hash(read_file(options.scene)));
  header["orbs.spp"] = std::to_string(rendering.samples_per_pixel);
  header["orbs.seed"] = std::to_string(options.render.seed);
  header["orbs.trace_depth"] = std::to_string(scene.trace_depth);
  header["orbs.sampler"] = options.sampler;
  header["orbs.direct_light"] = options.direct_light;
  header["orbs.light_selection"] = world.light_bvh.empty()         ? "power"
                                   : world.light_bvh.has_learned() ? "learned"
                                                                   : "bvh";
  header["orbs.intersection"] = options.intersection;
  header["orbs.roulette"] = world.roulette ? "yes" : "no";
  header["orbs.mirrored_light"] = world.mirror_planes.empty() ? "no" : "yes";
  header["orbs.light_paths"] = world.caustic_casters.empty() ? "no" : "yes";
  header["orbs.light_connections"] = world.connects_light_vertices ? "yes" : "no";
  if (const auto ignored = ignored_options(options, world); !ignored.empty())
    header["orbs.ignored_options"] = fmt::format("{}", fmt::join(ignored, "; "));
  if (!options.fault.empty()) header["orbs.fault"] = options.fault;
  header["orbs.transport"] = std::string(scene::transport_name(world.transport));
  if (world.wants_stokes)
    header["orbs.stokes"] =
        "S0 to S3 in the frame of the image, for a viewer who faces the source: S1 > 0 horizontal, S2 > 0 at "
        "+45 degrees (right and up), S3 > 0 right-circular (the field rotates clockwise)";
  if (!scene.outputs.layers.empty())
    header["orbs.layers"] = fmt::format("{}", fmt::join(scene.outputs.layers, " "));
  if (const auto* cache = std::get_if<scene::IrradianceCache>(&world.integrator))
    stamp_cache(rendering, *cache);
  if (!world.solids.empty()) {
    const auto counts = tracer::root_counts(world.solids);
    header["orbs.undecided_roots"] = std::to_string(counts.undecided);
    header["orbs.unfinished_roots"] = std::to_string(counts.unfinished);
    header["orbs.zero_normals"] = std::to_string(counts.zero_normals);
  }
  if (!world.plugin_shapes.empty())
    header["orbs.plugin_faults"] = std::to_string(tracer::plugin_faults(world.plugin_shapes).count);
  if (rendering.variance_leaves_floats) header["orbs.variance"] = "left out: beyond the range of floats";
  header["orbs.bad_samples"] = std::to_string(rendering.bad_samples.count);
}

}  // namespace orbs::tracer_cli
