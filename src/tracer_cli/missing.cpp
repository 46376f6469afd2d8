#include "tracer_cli/missing.h"

#include "base/bad_samples.h"
#include "tracer/plugins/plugin_shape.h"
#include "tracer/shapes/solid.h"

#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::tracer_cli {

std::string too_much_missing(const tracer::Rendering& rendering, const tracer::World& world) {
  const double samples =
      static_cast<double>(rendering.samples_per_pixel) * static_cast<double>(rendering.image.pixel_count());
  std::vector<std::string> parts;
  const auto look_at = [&](std::uint64_t count, const char* what) {
    constexpr double kMillion = 1e6;
    const double share_ppm = kMillion * static_cast<double>(count) / samples;
    if (share_ppm > kMostBadSamples_ppm)
      parts.push_back(
          fmt::format("in {:.0f} samples {} {}, {:.3g} in a million", samples, count, what, share_ppm));
  };
  const auto roots = tracer::root_counts(world.solids);
  look_at(rendering.bad_samples.count, "were not finite");
  look_at(roots.unfinished, "searches for a root did not end");
  look_at(roots.zero_normals, "points of formulas had no gradient");
  look_at(tracer::plugin_faults(world.plugin_shapes).count, "answers of plug-ins broke the rules");
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace orbs::tracer_cli
