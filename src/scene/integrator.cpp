#include "scene/integrator.h"

#include "json/writer.h"
#include "scene/load/entry.h"
#include "scene/load/kind.h"

#include <array>
#include <cmath>

namespace orbs::scene {

void load(json::ObjectReader&, PathTracing&) {}

void load(json::ObjectReader& in, AmbientOcclusion& loaded) {
  if (in.has("distance")) loaded.distance_m = in.number("distance", kLength);
  const bool is_uniform = in.one_of_or("weight", "cosine", {"cosine", "uniform"}) == "uniform";
  loaded.weight = is_uniform ? OcclusionWeight::Uniform : OcclusionWeight::Cosine;
}

void load(json::ObjectReader& in, IrradianceCache& loaded) {
  constexpr json::Range kErrors{1e-3, 10};
  constexpr json::Range kSpacings_px{0.1, 10000};
  if (in.one_of_or("metric", "ward", {"ward", "tabellion_lamorlette"}) == "ward") {
    loaded.error = in.number_or("error", loaded.error, kErrors);
  } else {
    loaded.metric = CacheMetric::TabellionLamorlette;
    loaded.kappa = in.number_or("kappa", loaded.kappa, kErrors);
  }
  // As many points as a sampler has in one block, and enough for a ring of strata with neighbours.
  loaded.rays = in.integer_or("rays", loaded.rays, 8, 4096);
  if (in.has("spacing")) {
    const auto spacing = in.numbers("spacing", 2, kSpacings_px);
    if (spacing[0] > spacing[1])
      in.fail("spacing", "the first number is the least spacing and must not be above the second");
    loaded.least_spacing_px = spacing[0];
    loaded.most_spacing_px = spacing[1];
  }
  loaded.has_gradients = in.boolean_or("gradients", loaded.has_gradients);
  loaded.clamps_to_neighbours = in.boolean_or("neighbour_clamping", loaded.clamps_to_neighbours);
}

namespace {

void write(json::Writer&, const PathTracing&) {}

void write(json::Writer& out, const AmbientOcclusion& occlusion) {
  out.member("type", occlusion.kType);
  if (std::isfinite(occlusion.distance_m)) out.member("distance", occlusion.distance_m);
  out.member("weight", occlusion.weight == OcclusionWeight::Uniform ? "uniform" : "cosine");
}

void write(json::Writer& out, const IrradianceCache& cache) {
  out.member("type", cache.kType);
  if (cache.metric == CacheMetric::Ward)
    out.member("metric", "ward").member("error", cache.error);
  else
    out.member("metric", "tabellion_lamorlette").member("kappa", cache.kappa);
  out.member("rays", cache.rays);
  out.key("spacing").numbers(std::array{cache.least_spacing_px, cache.most_spacing_px});
  out.member("gradients", cache.has_gradients).member("neighbour_clamping", cache.clamps_to_neighbours);
}

}  // namespace

Integrator load_integrator(json::ObjectReader& in) {
  return load_kind<Integrator>(in, in, PathTracing::kType);
}

void write_integrator(json::Writer& out, const Integrator& integrator) {
  std::visit([&](const auto& one) { write(out, one); }, integrator);
}

std::string no_paths_reason(const Integrator& integrator) {
  return std::visit(
      [](const auto& one) -> std::string {
        if constexpr (requires { one.kNoPaths; }) return one.kNoPaths;
        return "";
      },
      integrator);
}

}  // namespace orbs::scene
