// The example of a plug-in against the same surface as an implicit one, whose roots are found by interval
// arithmetic.
#include "property/hashed_numbers.h"
#include "scene/shapes/expression.h"
#include "structure/source_files.h"
#include "tracer/plugins/plugin_hit.h"
#include "tracer/shapes/implicit_boundary.h"

#include <cmath>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

using namespace orbs;
using tests::uniform;

namespace {

constexpr double kHalfSize = 1.25;
constexpr double kCurvature = 0.6;

tracer::PluginShape saddle() {
  const auto file = std::filesystem::path(ORBS_BINARY_DIR) / "plugins/saddle.so";
  return tracer::make_plugin_shape(
      {"s", scene::PluginForm{"saddle", {{"half_size", kHalfSize}, {"k", kCurvature}}}, Mat4{}, 0}, "s", {},
      {{"saddle", tracer::open_plugin(file)}});
}

tracer::ImplicitLeaf formula() {
  const double height = 1.001 * kCurvature * kHalfSize * kHalfSize;  // the box cuts x and y alone
  return {{scene::parse_expression(fmt::format("z - {} * (x^2 - y^2)", kCurvature)),
           {-kHalfSize, -kHalfSize, -height},
           {kHalfSize, kHalfSize, height},
           false}};
}

Vec3d in_cube(std::uint64_t i, std::uint64_t d) {
  return {2.0 * uniform(i, d) - 1, 2.0 * uniform(i, d + 1) - 1, 2.0 * uniform(i, d + 2) - 1};
}

// From a sphere around the saddle to places in and beside it, and from within it, with directions of any
// length.
tracer::LocalRay random_ray(std::uint64_t i) {
  const Vec3d to = in_cube(i, 3) * (1.3 * kHalfSize);
  const Vec3d from = i % 4 == 0 ? in_cube(i, 0) * kHalfSize : normalised(in_cube(i, 0)) * (4 * kHalfSize);
  return {from, (to - from) * (0.1 + 2.0 * uniform(i, 6))};
}

}  // namespace

TEST(PluginSaddle, HasTheHitsOfTheSameImplicitSurface) {
  constexpr int kRays = 4000;
  const auto plugin = saddle();
  const auto implicit = formula();
  tracer::RootCounts counts;
  int hits = 0;
  double largest_t = 0;
  double largest_normal = 0;
  for (std::uint64_t i = 0; i < kRays; ++i) {
    const auto ray = random_ray(i);
    const auto exact = next_boundary(implicit, ray, 0, tracer::Roots::All, counts);
    const auto found =
        intersect(plugin, {ray.origin, ray.direction, 0, std::numeric_limits<double>::infinity()});
    ASSERT_EQ(found.has_value(), std::isfinite(exact.t)) << i;
    if (!found) continue;
    ++hits;
    largest_t = std::max(largest_t, std::abs(found->t - exact.t));
    const Vec3d normal = tracer::implicit_normal(implicit.form.expression, point_at(ray, exact.t)).value();
    largest_normal = std::max(largest_normal, length(found->normal - normal));
  }
  EXPECT_GT(hits, kRays / 4);
  EXPECT_LT(hits, kRays);
  EXPECT_LE(largest_t, 1e-9);
  EXPECT_LE(largest_normal, 1e-9);
  EXPECT_EQ(plugin.faults->distance + plugin.faults->normal + plugin.faults->uv + plugin.faults->place, 0U);
  RecordProperty("hits", hits);
  RecordProperty("largest_t", fmt::format("{:.3g}", largest_t));
  RecordProperty("largest_normal", fmt::format("{:.3g}", largest_normal));
}
