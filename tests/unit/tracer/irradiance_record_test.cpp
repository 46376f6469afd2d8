// Irradiance, gradients and distances from stratified hemispheres against closed forms, and the rules by
// which records are used.
#include "tracer/irradiance_cache/hemisphere.h"
#include "tracer/irradiance_cache/irradiance_cache.h"
#include "tracer/sampling/sampler.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::tracer;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// What a floor at distance x from a long wall sees in a direction: the floor's normal is +z, the wall lies
// towards -x, has the height and the radiance 1. Nothing else is there.
IncomingLight by_wall(Vec3f direction, float x, float height) {
  if (!(direction.x < 0)) return {};
  const float run = -x / direction.x;
  if (run * direction.z > height) return {};
  return {{1, 1, 1}, run};
}

// Means over independent hemispheres, so that sampling noise is small beside the tolerances.
struct Means {
  double irradiance = 0;
  double gradient_x = 0;
  double gradient_y = 0;
};

Means by_wall_mean(float x, float height, int rays) {
  constexpr std::uint32_t kHemispheres = 100;
  const HemisphereStrata strata = hemisphere_strata(rays);
  Means means;
  for (std::uint32_t h = 0; h < kHemispheres; ++h) {
    std::vector<IncomingLight> light;
    for (std::size_t i = 0; i < strata.count(); ++i) {
      const auto u = independent_point(h * 7919 + 1, static_cast<std::uint32_t>(i));
      light.push_back(by_wall(direction_in_stratum(strata, i, {u[0], u[1]}), x, height));
    }
    const auto estimate = estimate_irradiance(strata, light);
    means.irradiance += static_cast<double>(estimate.irradiance.x) / kHemispheres;
    means.gradient_x += static_cast<double>(estimate.translation_gradient[0].x) / kHemispheres;
    means.gradient_y += static_cast<double>(estimate.translation_gradient[0].y) / kHemispheres;
  }
  return means;
}

std::vector<IncomingLight> hemisphere_of(const HemisphereStrata& strata,
                                         const std::function<IncomingLight(Vec3f)>& seen) {
  std::vector<IncomingLight> light;
  for (std::size_t i = 0; i < strata.count(); ++i) {
    const auto u = independent_point(17, static_cast<std::uint32_t>(i));
    light.push_back(seen(direction_in_stratum(strata, i, {u[0], u[1]})));
  }
  return light;
}

IrradianceRecord record_at(Vec3f position, Vec3f normal, float distance) {
  IrradianceRecord record;
  record.at = {position, 0, normal};
  record.irradiance = {1, 1, 1};
  record.distance = distance;
  record.least_spacing = 0;
  record.most_spacing = kInfinity;
  return record;
}

const scene::IrradianceCache kWard{};

}  // namespace

// E = (pi / 2) (1 - x / sqrt(x^2 + H^2)) and its derivative by x, at two distances.
TEST(IrradianceHemisphere, HasTheIrradianceOfAFloorByAWall) {
  EXPECT_NEAR(by_wall_mean(0.5F, 1, 4096).irradiance, 0.86831485, 0.002);
  EXPECT_NEAR(by_wall_mean(1, 1, 4096).irradiance, 0.46007559, 0.002);
}

// The estimator takes the edge of the wall to lie between strata, at the shorter of two rays, so it errs in
// proportion to their size: with 1024 by 10 %, with sixteen times as many by a quarter of that.
TEST(IrradianceHemisphere, HasTheTranslationGradientOfAFloorByAWall) {
  constexpr double kNear = -1.12397036;
  constexpr double kFar = -0.55536037;
  const auto near = by_wall_mean(0.5F, 1, 16384);
  EXPECT_NEAR(near.gradient_x, kNear, 0.04 * -kNear);
  EXPECT_NEAR(near.gradient_y, 0, 0.01);
  EXPECT_NEAR(by_wall_mean(1, 1, 16384).gradient_x, kFar, 0.04 * -kFar);
  EXPECT_NEAR(by_wall_mean(0.5F, 1, 1024).gradient_x, kNear, 0.15 * -kNear);
}

// A quarter of the sphere, x < 0, has the radiance 1. Under a normal that is turned by the angle t towards it
// E = (pi / 2) (1 + sin t) as long as no light comes from below, so that its derivative is pi / 2 at t = 0.
// n x n' is +y for n' towards +x, hence -y here.
TEST(IrradianceHemisphere, HasTheRotationGradientOfAHalfLitSky) {
  const HemisphereStrata strata = hemisphere_strata(4096);
  const auto light = hemisphere_of(strata, [](Vec3f d) {
    return IncomingLight{d.x < 0 ? Vec3f{1, 2, 0} : Vec3f{}, kInfinity};
  });
  const auto gradient = estimate_irradiance(strata, light).rotation_gradient;
  EXPECT_NEAR(static_cast<double>(gradient[0].y), -std::numbers::pi / 2, 0.02);
  EXPECT_NEAR(static_cast<double>(gradient[0].x), 0, 0.02);
  EXPECT_NEAR(static_cast<double>(gradient[1].y), -std::numbers::pi, 0.04);
  EXPECT_EQ(length(gradient[2]), 0);
}

// Furnace: even light has the irradiance pi L and no gradients, whatever the distances.
TEST(IrradianceHemisphere, EvenLightHasNoGradients) {
  const HemisphereStrata strata = hemisphere_strata(200);
  const auto light = hemisphere_of(strata, [](Vec3f d) { return IncomingLight{{2, 2, 2}, 0.1F + d.z}; });
  const auto estimate = estimate_irradiance(strata, light);
  EXPECT_NEAR(static_cast<double>(estimate.irradiance.y), 2 * std::numbers::pi, 1e-6);
  EXPECT_EQ(length(estimate.translation_gradient[1]), 0);
  EXPECT_LT(length(estimate.rotation_gradient[1]), 1e-6F);
}

// The harmonic mean to an infinite wall is 3 pi x / 2 for cosine-weighted rays, 4.7 times the distance; the
// least ray is close to the distance.
TEST(IrradianceHemisphere, HasTheHarmonicMeanDistanceToAWall) {
  const HemisphereStrata strata = hemisphere_strata(4096);
  const auto light = hemisphere_of(strata, [](Vec3f d) { return by_wall(d, 0.5F, kInfinity); });
  const auto estimate = estimate_irradiance(strata, light);
  EXPECT_NEAR(static_cast<double>(estimate.harmonic_mean_distance), 1.5 * std::numbers::pi * 0.5, 0.01);
  EXPECT_NEAR(static_cast<double>(estimate.least_distance), 0.5, 0.01);
}

TEST(IrradianceHemisphere, DirectionsLieInTheirStrata) {
  for (const int rays : {8, 64, 500, 4096}) {
    const HemisphereStrata strata = hemisphere_strata(rays);
    EXPECT_NEAR(static_cast<double>(strata.count()), rays, 0.15 * rays);
    for (std::size_t i = 0; i < strata.count(); ++i) {
      const Vec3f d = direction_in_stratum(strata, i, {0.5F, 0.5F});
      EXPECT_NEAR(static_cast<double>(length(d)), 1, 1e-6);
      EXPECT_GT(d.z, 0);
      EXPECT_EQ(static_cast<std::size_t>((1 - d.z * d.z) * static_cast<float>(strata.rings)),
                i / static_cast<std::size_t>(strata.sectors));
    }
  }
}

// From a record at x = 0.5 by the wall, with the exact irradiance and gradient: a constant is 13.9, 29.6 and
// 67.0 % off at +0.1, +0.2 and +0.4, the gradient -0.9, -4.0 and -19.5 %.
TEST(IrradianceRecord, ExtrapolatesByItsGradient) {
  auto record = record_at({0.5F, 0, 0}, {0, 0, 1}, 1);
  const auto exact = [](double x) { return std::numbers::pi / 2 * (1 - x / std::hypot(x, 1.0)); };
  record.irradiance.x = static_cast<float>(exact(0.5));
  const auto relative_error_at = [&](float step) {
    const double value = static_cast<double>(extrapolated(record, {{0.5F + step, 0, 0}, 0, {0, 0, 1}}).x);
    return value / exact(0.5 + static_cast<double>(step)) - 1;
  };
  EXPECT_NEAR(relative_error_at(0.1F), 0.139, 0.001);
  EXPECT_NEAR(relative_error_at(0.4F), 0.670, 0.001);
  record.translation_gradient[0] = {-1.12397036F, 0, 0};
  EXPECT_NEAR(relative_error_at(0.1F), -0.009, 0.001);
  EXPECT_NEAR(relative_error_at(0.2F), -0.040, 0.001);
  EXPECT_NEAR(relative_error_at(0.4F), -0.195, 0.001);
}

// A normal n' that is turned from n = z towards +x: n x n' is +y.
TEST(IrradianceRecord, TurnsByItsRotationGradient) {
  auto record = record_at({}, {0, 0, 1}, 1);
  record.rotation_gradient[0] = {0, -2, 0};
  const float angle = 0.1F;
  const Vec3f turned{std::sin(angle), 0, std::cos(angle)};
  EXPECT_NEAR(extrapolated(record, {{}, 0, turned}).x, 1 - 2 * std::sin(angle), 1e-6);
  EXPECT_NEAR(extrapolated(record, {{}, 0, turned}).y, 1, 1e-6);
}

TEST(IrradianceRecord, WardsErrorCountsDistanceAndAngle) {
  const auto record = record_at({}, {0, 0, 1}, 2);
  EXPECT_NEAR(reach(kWard, record), 0.4, 1e-6);
  EXPECT_NEAR(relative_error(kWard, record, {{0.1F, 0, 0}, 0, {0, 0, 1}}), 0.25, 1e-6);
  const Vec3f turned{std::sin(0.1F), 0, std::cos(0.1F)};
  EXPECT_NEAR(relative_error(kWard, record, {{0.1F, 0, 0}, 0, turned}),
              0.25 + std::sqrt(1 - std::cos(0.1)) / 0.2, 1e-4);
  EXPECT_NEAR(record_weight(kWard, 0.25F), 3, 1e-6);
}

TEST(IrradianceRecord, TabellionAndLamorlettesErrorIsTheLargerOfBoth) {
  scene::IrradianceCache settings;
  settings.metric = scene::CacheMetric::TabellionLamorlette;
  settings.kappa = 2;
  auto record = record_at({}, {0, 0, 1}, 2);
  EXPECT_NEAR(reach(settings, record), 0.5, 1e-6);
  const auto ten_degrees = static_cast<float>(std::numbers::pi / 18);
  const Vec3f turned{std::sin(ten_degrees), 0, std::cos(ten_degrees)};
  EXPECT_NEAR(relative_error(settings, record, {{0.1F, 0, 0}, 0, turned}), 2, 1e-3);
  EXPECT_NEAR(relative_error(settings, record, {{0.1F, 0, 0}, 0, {0, 0, 1}}), 0.2, 1e-6);
  record.most_spacing = 0.25F;
  EXPECT_NEAR(reach(settings, record), 0.125, 1e-6);
  record.least_spacing = record.most_spacing = 3;
  EXPECT_NEAR(reach(settings, record), 1.5, 1e-6);
  EXPECT_NEAR(record_weight(settings, 0.25F), 0.75, 1e-6);
}

TEST(IrradianceRecord, IsNotUsedBehindItsSurface) {
  const auto record = record_at({}, {0, 0, 1}, 2);
  EXPECT_FALSE(is_behind(record, {{0.1F, 0, 0}, 0, {0, 0, 1}}));
  EXPECT_FALSE(is_behind(record, {{0.1F, 0, 0.05F}, 0, {0, 0, 1}}));
  EXPECT_TRUE(is_behind(record, {{0.1F, 0, -0.01F}, 0, {0, 0, 1}}));
  EXPECT_FALSE(is_behind(record, {{0.1F, 0, -0.001F}, 0, {0, 0, 1}}));
  // On a ball of radius 1 about (0, 0, -1).
  const float angle = 0.3F;
  EXPECT_FALSE(is_behind(
      record, {{std::sin(angle), 0, std::cos(angle) - 1}, 0, {std::sin(angle), 0, std::cos(angle)}}));
}

// E / |gradient| is 1 m: a = 0.2 reaches 0.2 m. Where the record has to reach 0.8 m, a quarter of the
// gradient changes the irradiance by the same 20 %.
TEST(IrradianceRecord, DistanceAndGradientLimitEachOther) {
  auto record = record_at({}, {0, 0, 1}, 10);
  limit_by_gradient(kWard, record);
  EXPECT_EQ(record.distance, 10);
  record.translation_gradient[0] = {3, 0, 0};
  limit_by_gradient(kWard, record);
  EXPECT_NEAR(record.distance, 1, 1e-6);
  EXPECT_EQ(record.translation_gradient[0].x, 3);
  record.distance = 10;
  record.least_spacing = 0.8F;
  limit_by_gradient(kWard, record);
  EXPECT_NEAR(record.distance, 1, 1e-6);
  EXPECT_NEAR(record.translation_gradient[0].x, 0.75, 1e-6);
}

namespace {

IrradianceCache cache_with_settings(const scene::IrradianceCache& settings) {
  return {settings, {-2, -2, -2}, {2, 2, 2}};
}

}  // namespace

// |R_i - R_j| <= |p_i - p_j| for all pairs after any order of insertions, and for none of some without it.
TEST(IrradianceCache, NeighbourClampingKeepsTheTriangleInequality) {
  for (const bool clamps : {true, false}) {
    scene::IrradianceCache settings;
    settings.clamps_to_neighbours = clamps;
    auto cache = cache_with_settings(settings);
    for (std::uint32_t i = 0; i < 200; ++i) {
      const auto u = independent_point(5, i);
      cache.insert(record_at({2 * u[0] - 1, 2 * u[1] - 1, 0}, {0, 0, 1}, 0.01F + 3 * u[2] * u[2]));
    }
    int violations = 0;
    for (const auto& a : cache.records())
      for (const auto& b : cache.records())
        violations += std::abs(a.distance - b.distance) > length(a.at.position - b.at.position) + 1e-6F;
    EXPECT_EQ(violations == 0, clamps) << violations;
  }
}

// The octree finds what a search of all records finds.
TEST(IrradianceCache, FindsEveryRecordThatMayBeUsed) {
  scene::IrradianceCache settings;
  settings.clamps_to_neighbours = false;
  auto cache = cache_with_settings(settings);
  for (std::uint32_t i = 0; i < 300; ++i) {
    const auto u = independent_point(9, i);
    cache.insert(record_at({2 * u[0] - 1, 2 * u[1] - 1, 2 * u[2] - 1}, {0, 0, 1}, 1.5F * u[3]));
  }
  int covered = 0;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const auto u = independent_point(10, i);
    const SurfaceElement at{{2 * u[0] - 1, 2 * u[1] - 1, 2 * u[2] - 1}, 0, {0, 0, 1}};
    bool has_record = false;
    for (const auto& record : cache.records())
      has_record = has_record || (relative_error(settings, record, at) < 1 && !is_behind(record, at));
    EXPECT_EQ(cache.covers(at), has_record);
    EXPECT_EQ(cache.lookup(at).has_value(), has_record);
    covered += has_record;
  }
  EXPECT_GT(covered, 200);
  EXPECT_LT(covered, 1800);
}

TEST(IrradianceCache, InterpolatesBetweenRecords) {
  auto cache = cache_with_settings({});
  auto dark = record_at({0, 0, 0}, {0, 0, 1}, 5);
  auto bright = record_at({0.5F, 0, 0}, {0, 0, 1}, 5);
  dark.irradiance = {1, 1, 1};
  bright.irradiance = {3, 3, 3};
  cache.insert(dark);
  cache.insert(bright);
  const auto value_at = [&](float x) { return cache.lookup({{x, 0, 0}, 0, {0, 0, 1}})->value.x; };
  EXPECT_EQ(value_at(0), 1);
  EXPECT_EQ(value_at(0.5F), 3);
  EXPECT_NEAR(value_at(0.25F), 2, 1e-6);
  EXPECT_FALSE(cache.lookup({{0.25F, 0, 0}, 0, {0, 0, -1}}).has_value());
  EXPECT_FALSE(cache.lookup({{1.9F, 0, 0}, 0, {0, 0, 1}}).has_value());
  EXPECT_FALSE(cache.lookup({{9, 0, 0}, 0, {0, 0, 1}}).has_value());
}

TEST(IrradianceCache, CountsIrradianceBelowZero) {
  scene::IrradianceCache settings;
  settings.error = 5;  // uses records farther than their gradients are good for
  auto cache = cache_with_settings(settings);
  auto record = record_at({}, {0, 0, 1}, 1);
  record.translation_gradient = {Vec3f{-1, 0, 0}, Vec3f{}, Vec3f{}};
  cache.insert(record);
  const auto found = cache.lookup({{1.5F, 0, 0}, 0, {0, 0, 1}});
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->was_negative);
  EXPECT_EQ(found->value.x, 0);
  EXPECT_EQ(found->value.y, 1);
}
