// Every sampling routine draws from the density that it states, cell by cell, over the range of its
// parameters. Tests of totals and moments alone would let samples lie in wrong places. The level of the whole
// file is 1 in 1000 by Bonferroni's correction; seeds are fixed, so a result does not change from run to run.
#include "property/chi_square.h"
#include "property/hashed_numbers.h"
#include "tracer/bsdf/materials.h"
#include "tracer/light/caustic_casters.h"
#include "tracer/light/emitter.h"

#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::tracer;
using tests::Cell;
using tests::chi_square;
using tests::ChiSquare;
using tests::four_uniform;
using Rgb = Vec3f;
using TestedBsdf = tracer::AnyBsdf<Rgb, 1>;

constexpr double kPi64 = std::numbers::pi;
constexpr int kMostTests = 400;  // more than this file makes
constexpr double kLevel = 1e-3 / kMostTests;
constexpr std::size_t kTrials = 40000;

void expect_density(const ChiSquare& test, const std::string& name) {
  EXPECT_GT(test.p_value, kLevel) << name << ": chi^2 " << test.statistic << " at " << test.degrees
                                  << " degrees of freedom; accepted " << test.accepted
                                  << ", the density integrates to " << test.integral;
}

// Directions about an axis as (log r, phi), in which lobes of any width have about the same shape. r is the
// length of the chord between direction and axis, so that r dr dphi is the solid angle.
class LogPolarMap {
 public:
  explicit LogPolarMap(Vec3d axis) : z_(normalised(axis)) {
    x_ = normalised(cross(std::abs(z_.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, z_));
    y_ = cross(z_, x_);
  }
  Cell domain() const { return {{kLeastLog, -kPi64}, {std::log(2.0), kPi64}}; }
  Vec2d point_of(Vec3d direction) const {
    const Vec3d chord = normalised(direction) - z_;
    return {std::max(kLeastLog, std::log(length(chord))), std::atan2(dot(chord, y_), dot(chord, x_))};
  }
  Vec3d direction_of(Vec2d p) const {
    const double r = std::exp(p.x);
    const double sine = r * std::sqrt(std::max(0.0, 1 - r * r / 4));
    return z_ * (1 - r * r / 2) + x_ * (sine * std::cos(p.y)) + y_ * (sine * std::sin(p.y));
  }
  static double solid_angle_per_area(Vec2d p) { return std::exp(2 * p.x); }

 private:
  static constexpr double kLeastLog = -18;  // below the spacing of single-precision directions
  Vec3d z_;
  Vec3d x_;
  Vec3d y_;
};

Vec3f view(float cosine) {
  const float sine = std::sqrt(1 - cosine * cosine);
  return {sine * 0.8F, sine * 0.6F, cosine};
}

// Reflection (side +1) or transmission (side -1), each about the centre of its lobe.
ChiSquare test_of(const TestedBsdf& bsdf, Vec3f wo, int side, Vec3d axis) {
  const LogPolarMap map(axis);
  std::vector<Vec2d> points;
  for (std::uint64_t i = 0; i < kTrials; ++i)
    if (const auto chosen = sample(bsdf, wo, four_uniform(i)))
      if (chosen->wi.z * static_cast<float>(side) > 0)
        points.push_back(map.point_of(cast<double>(chosen->wi)));
  return chi_square(points, kTrials, map.domain(), [&](Vec2d p) {
    const Vec3f wi = cast<float>(map.direction_of(p));
    if (!(wi.z * static_cast<float>(side) > 0)) return 0.0;
    return evaluate(bsdf, wo, wi).pdf * LogPolarMap::solid_angle_per_area(p);
  });
}

Boundary<1> boundary(std::complex<float> index) { return {.index = {index}, .film_index = {}, .nm = {}}; }

const Rgb kWhite{1, 1, 1};
const std::complex<float> kSilver{0.06F, 3.6F};
constexpr std::array kCosines{1.0F, 0.7F, 0.2F, 0.02F, 0.002F};

std::string text_of(const char* name, float alpha, float cosine) {
  return std::string(name) + " alpha " + std::to_string(alpha) + " cos " + std::to_string(cosine);
}

}  // namespace

TEST(SamplingDensity, OfDiffuseSurfaces) {
  for (const float cosine : kCosines) {
    const Vec3f wo = view(cosine);
    expect_density(test_of(LambertBsdf<Rgb>{kWhite}, wo, 1, {0, 0, 1}), text_of("lambert", 0, cosine));
    expect_density(test_of(make_oren_nayar(kWhite, 0.5F), wo, 1, {0, 0, 1}),
                   text_of("oren_nayar", 0, cosine));
  }
}

TEST(SamplingDensity, OfRoughReflection) {
  for (const float alpha : {1e-4F, 1e-3F, 0.01F, 0.1F, 0.5F, 1.0F})
    for (const float cosine : kCosines) {
      // Lobes that are narrower than this across the view are resolved neither by directions in single
      // precision nor by the quadrature.
      if (alpha * cosine < 1e-5F) continue;
      const Vec3f wo = view(cosine);
      const Vec3d mirror{-wo.x, -wo.y, wo.z};
      expect_density(test_of(GgxBsdf<Rgb>{kWhite, alpha}, wo, 1, mirror), text_of("ggx", alpha, cosine));
      for (const bool is_beckmann : {false, true}) {
        const Microfacets facets{alpha, is_beckmann, true};
        expect_density(test_of(RoughConductorBsdf<Rgb, 1>{boundary(kSilver), facets}, wo, 1, mirror),
                       text_of(is_beckmann ? "beckmann conductor" : "ggx conductor", alpha, cosine));
      }
    }
}

TEST(SamplingDensity, OfRoughGlassOnBothSides) {
  for (const float eta : {1.5F, 1 / 1.5F, 1.01F, 0.95F})
    for (const float alpha : {0.01F, 0.1F, 0.5F, 1.0F})
      for (const float cosine : {1.0F, 0.7F, 0.2F, 0.02F}) {
        const Vec3f wo = view(cosine);
        const RoughGlassBsdf<Rgb> glass{kWhite, eta, alpha};
        const auto name = text_of("rough glass", alpha, cosine) + " eta " + std::to_string(eta);
        expect_density(test_of(glass, wo, 1, {-wo.x, -wo.y, wo.z}), name + " reflection");
        const auto into = refracted(wo, Vec3f{0, 0, 1}, eta);
        const Vec3d axis = into ? cast<double>(*into) : Vec3d{-wo.x, -wo.y, -0.01};
        expect_density(test_of(glass, wo, -1, axis), name + " transmission");
      }
}

// So close to 1 the transmitted lobe is too narrow for cells. The pdf of a direction is that with which it
// was sampled; where the half vector cancels to nothing, at most one in a thousand has none.
TEST(SamplingDensity, OfRoughGlassWithAnIndexNextToOne) {
  for (const float alpha : {0.01F, 0.1F, 0.5F, 1.0F})
    for (const float cosine : {0.7F, 0.2F, 0.02F}) {
      const RoughGlassBsdf<Rgb> glass{kWhite, 1.0001F, alpha};
      const Vec3f wo = view(cosine);
      int transmitted = 0;
      int wrong = 0;
      for (std::uint64_t i = 0; i < kTrials / 2; ++i) {
        const auto chosen = sample(glass, wo, four_uniform(i));
        if (!chosen || chosen->wi.z > 0) continue;
        ++transmitted;
        const float ratio = evaluate(glass, wo, chosen->wi).pdf / chosen->pdf;
        wrong += ratio > 0.8F && ratio < 1.25F ? 0 : 1;
      }
      EXPECT_LE(wrong, transmitted / 1000) << text_of("rough glass", alpha, cosine);
    }
}

// Points of a rectangle by its own coordinates in [-1, 1]^2: far, near (sampled by solid angle), at the
// switch between both, edge-on and almost touching.
TEST(SamplingDensity, OfRectangles) {
  const RectEmitter rect{{0, 2, 0}, {0.5F, 0, 0}, {0, 0, 1}, {0, -1, 0}, 2, true};
  for (const Vec3f from : {Vec3f{0, 0, 0}, Vec3f{0.2F, 1.9F, 0.3F}, Vec3f{3, -2, 1}, Vec3f{0, -0.83F, 0},
                           Vec3f{1.2F, 1.99F, 0}, Vec3f{0.5F, 1.999F, 1}, Vec3f{0.1F, 1.9999F, 0.1F}}) {
    std::vector<Vec2d> points;
    for (std::uint64_t i = 0; i < kTrials; ++i) {
      const auto u = four_uniform(i);
      if (const auto point = sample_towards(EmitterShape(rect), from, u[0], u[1]))
        points.push_back({(point->position.x) / 0.5, double{point->position.z}});
    }
    const auto density = [&](Vec2d p) {
      if (std::max(std::abs(p.x), std::abs(p.y)) > 1) return 0.0;
      const Vec3f position{static_cast<float>(0.5 * p.x), 2, static_cast<float>(p.y)};
      const Vec3d d = cast<double>(position - from);
      const double distance2 = dot(d, d);
      return pdf_towards(EmitterShape(rect), from, position) * std::abs(d.y) /
             (distance2 * std::sqrt(distance2)) * 0.5;
    };
    expect_density(chi_square(points, kTrials, {{-1.0001, -1.0001}, {1.0001, 1.0001}}, density),
                   "rectangle from y = " + std::to_string(from.y));
  }
}

TEST(SamplingDensity, OfBalls) {
  for (const float distance : {1.0001F, 1.01F, 1.5F, 10.0F, 100.0F})
    for (const Vec3f radii : {Vec3f{1, 1, 1}, Vec3f{0.5F, 1, 0.7F}}) {
      SphereEmitter ball;
      ball.axes = {Vec3f{radii.x, 0, 0}, Vec3f{0, radii.y, 0}, Vec3f{0, 0, radii.z}};
      ball.inverse = {Vec3f{1 / radii.x, 0, 0}, Vec3f{0, 1 / radii.y, 0}, Vec3f{0, 0, 1 / radii.z}};
      ball.determinant = radii.x * radii.y * radii.z;
      const Vec3f from{0, -distance, 0};
      const LogPolarMap map({0, 1, 0});
      std::vector<Vec2d> points;
      for (std::uint64_t i = 0; i < kTrials; ++i) {
        const auto u = four_uniform(i);
        if (const auto point = sample_towards(EmitterShape(ball), from, u[0], u[1]))
          points.push_back(map.point_of(cast<double>(point->position - from)));
      }
      // The ellipsoid |inverse p| = 1 along the direction; where it is missed there is no density.
      const auto density = [&](Vec2d p) {
        const Vec3d w = map.direction_of(p);
        const Vec3d o{0, -double{distance} / radii.y, 0};
        const Vec3d d{w.x / radii.x, w.y / radii.y, w.z / radii.z};
        const double b = dot(o, d);
        const double root = b * b - dot(d, d) * (dot(o, o) - 1);
        if (!(root > 0) || b > 0) return 0.0;
        const double t = (-b - std::sqrt(root)) / dot(d, d);
        return pdf_towards(EmitterShape(ball), from, from + cast<float>(w * t)) *
               LogPolarMap::solid_angle_per_area(p);
      };
      expect_density(chi_square(points, kTrials, map.domain(), density),
                     "ball " + std::to_string(radii.x) + " from " + std::to_string(distance));
    }
}

TEST(SamplingDensity, OfDirectionsTowardsCasters) {
  const std::vector<BoundingSphere> casters{{{0, 3, 0}, 0.5F}, {{1, 2, 0}, 0.2F}, {{0, 0.1F, 0}, 1}};
  const LogPolarMap map({0, 1, 0});
  for (std::size_t count = 1; count <= casters.size(); ++count) {
    const std::vector<BoundingSphere> some(casters.begin(), casters.begin() + static_cast<int>(count));
    std::vector<Vec2d> points;
    for (std::uint64_t i = 0; i < kTrials; ++i) {
      const auto u = four_uniform(i);
      points.push_back(map.point_of(
          cast<double>(sample_towards_casters(some, {}, {0, 1, 0}, u[0], u[1], u[2]).direction)));
    }
    const auto density = [&](Vec2d p) {
      const Vec3d w = map.direction_of(p);
      double sum = 0;
      for (const auto& caster : some) {
        const Vec3d to = cast<double>(caster.centre);
        const double sin2 = double{caster.radius} * caster.radius / dot(to, to);
        if (sin2 >= 1)
          sum += std::max(0.0, w.y) / kPi64;
        else if (const double c = std::sqrt(1 - sin2); dot(w, normalised(to)) >= c)
          sum += 1 / (2 * kPi64 * (1 - c));
      }
      return sum / static_cast<double>(count) * LogPolarMap::solid_angle_per_area(p);
    };
    expect_density(chi_square(points, kTrials, map.domain(), density), std::to_string(count) + " casters");
  }
}

// The test itself can fail: samples of a slightly wider lobe, or three hundredths of them elsewhere.
TEST(SamplingDensity, ChiSquareFindsWrongSamples) {
  const LogPolarMap map({0, 0, 1});
  const auto test_with = [&](const auto& spoiled) {
    std::vector<Vec2d> points;
    for (std::uint64_t i = 0; i < kTrials; ++i) {
      const auto u = four_uniform(i);
      points.push_back(map.point_of(cast<double>(spoiled(u))));
    }
    return chi_square(points, kTrials, map.domain(), [&](Vec2d p) {
      return std::max(0.0, map.direction_of(p).z) / kPi64 * LogPolarMap::solid_angle_per_area(p);
    });
  };
  const auto right = [](const auto& u) { return sample_cosine(u[0], u[1]); };
  const auto shifted = [](const auto& u) {
    return normalised(sample_cosine(u[0], u[1]) + Vec3f{0, 0, 0.05F});
  };
  const auto elsewhere = [](const auto& u) {
    return u[2] < 0.03F ? normalised(Vec3f{0.1F + 0.01F * u[0], 0.01F * u[1], 1}) : sample_cosine(u[0], u[1]);
  };
  EXPECT_GT(test_with(right).p_value, kLevel);
  EXPECT_LT(test_with(shifted).p_value, kLevel);
  EXPECT_LT(test_with(elsewhere).p_value, kLevel);
}
