// Every sampling routine draws from the density that it states, cell by cell, over the range of its
// parameters. Tests of totals and moments alone would let samples lie in wrong places.
#include "property/hashed_numbers.h"
#include "property/sampling_density.h"
#include "tracer/bsdf/materials.h"
#include "tracer/light/caustic_casters.h"
#include "tracer/light/emitter.h"

#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::tracer;
using tests::chi_square;
using tests::ChiSquare;
using tests::expect_density;
using tests::four_uniform;
using tests::kTrials;
using tests::LogPolarMap;
using Rgb = Vec3f;
using TestedBsdf = tracer::AnyBsdf<Rgb, 1>;

constexpr double kPi64 = std::numbers::pi;

Vec3f view(float cosine) {
  const float sine = std::sqrt(1 - cosine * cosine);
  return {sine * 0.8F, sine * 0.6F, cosine};
}

// Reflection (side +1) or transmission (side -1), each about the centre of its lobe.
ChiSquare test_of(const TestedBsdf& bsdf, Vec3f wo, int side, const LogPolarMap& map) {
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

ChiSquare test_of(const TestedBsdf& bsdf, Vec3f wo, int side, Vec3d axis) {
  return test_of(bsdf, wo, side, LogPolarMap(axis));
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
      // Lobes that are narrower than this across the view are a few floats wide, and no cells resolve them:
      // narrow_lobes_test.cpp has them.
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

TEST(SamplingDensity, OfRoughDielectricsOnBothSides) {
  for (const float eta : {1.5F, 1 / 1.5F})
    for (const float alpha : {0.01F, 0.1F, 0.5F})
      for (const float cosine : {1.0F, 0.7F, 0.2F})
        for (const bool is_beckmann : {false, true}) {
          const Vec3f wo = view(cosine);
          const RoughDielectricBsdf<Rgb, 1> glass{boundary(eta), {alpha, is_beckmann, true}};
          const auto name = text_of(is_beckmann ? "beckmann dielectric" : "ggx dielectric", alpha, cosine) +
                            " eta " + std::to_string(eta);
          expect_density(test_of(glass, wo, 1, {-wo.x, -wo.y, wo.z}), name + " reflection");
          const auto into = refracted(wo, Vec3f{0, 0, 1}, eta);
          const Vec3d axis = into ? cast<double>(*into) : Vec3d{-wo.x, -wo.y, -0.01};
          expect_density(test_of(glass, wo, -1, axis), name + " transmission");
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

namespace {

using Vec3l = Vec3<long double>;

// Walter et al. 2007, eq. 17, 20, 24 and 33, from the directions as they are, with the visible normals of
// Heitz 2014. Nothing cancels: long double has as many digits as the product of two floats and more.
double transmitted_pdf(Vec3f wo, Vec3f wi, float index, float alpha) {
  const Vec3l o = normalised(cast<long double>(wo));
  const Vec3l i = normalised(cast<long double>(wi));
  const long double eta = index;
  const Vec3l half = o + i * eta;
  const Vec3l m = normalised(half) * (half.z < 0 ? -1.0L : 1.0L);
  const long double cos_o = dot(o, m);
  const long double cos_i = dot(i, m);
  if (!(cos_o > 0) || cos_i > 0 || m.z <= 0) return 0;
  const long double s = (m.x * m.x + m.y * m.y) / (alpha * alpha) + m.z * m.z;
  const long double d = 1 / (std::numbers::pi_v<long double> * alpha * alpha * s * s);
  const long double tan2 = (o.x * o.x + o.y * o.y) / (o.z * o.z);
  const long double g1 = 2 / (1 + std::sqrt(1 + alpha * alpha * tan2));
  const long double rs = (cos_o + eta * cos_i) / (cos_o - eta * cos_i);
  const long double rp = (eta * cos_o + cos_i) / (eta * cos_o - cos_i);
  const long double fresnel = (rs * rs + rp * rp) / 2;
  return static_cast<double>((1 - fresnel) * g1 * cos_o * d / o.z * eta * eta * -cos_i / dot(half, half));
}

constexpr std::array kIndicesNextToOne{1.0001F, 1.001F, 0.9999F, 1.00001F};
constexpr std::array kRoughnessesNextToOne{1e-3F, 0.01F, 0.1F, 0.5F, 1.0F};

// The pdf that sample() states and that of evaluate() are those of the direction as it is, bit for bit of its
// floats: they differ from one float to the next by as much as the lobe is narrow. Most are within 1e-4. Just
// short of total reflection at grazing angles floats leave what is not reflected half a per cent.
void expect_pdfs_of(const TestedBsdf& bsdf, Vec3f wo, float eta, float alpha, const std::string& name) {
  double largest = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const auto chosen = sample(bsdf, wo, four_uniform(i));
    if (!chosen || !chosen->is_transmitted) continue;
    const double expected = transmitted_pdf(wo, chosen->wi, eta, alpha);
    largest = std::max(largest, std::abs(chosen->pdf - expected) / expected);
    largest = std::max(largest, std::abs(evaluate(bsdf, wo, chosen->wi).pdf - expected) / expected);
  }
  EXPECT_LT(largest, 1e-2) << name;
}

}  // namespace

// The half vector is the difference of two directions that are nearly opposite. Computed in single precision,
// the pdf was off by a factor of 800.
TEST(SamplingDensity, OfRoughGlassWithAnIndexNextToOneIsThatOfTheDirection) {
  for (const float eta : kIndicesNextToOne)
    for (const float alpha : kRoughnessesNextToOne)
      for (const float cosine : {1.0F, 0.7F, 0.2F, 0.02F}) {
        const Vec3f wo = view(cosine);
        const auto name = text_of("alpha", alpha, cosine) + " eta " + std::to_string(eta);
        expect_pdfs_of(RoughGlassBsdf<Rgb>{kWhite, eta, alpha}, wo, eta, alpha, "rough glass " + name);
        expect_pdfs_of(RoughDielectricBsdf<Rgb, 1>{boundary(eta), {alpha, false, false}}, wo, eta, alpha,
                       "rough dielectric " + name);
      }
}

// At oblique incidence the lobe is a few floats wide, too narrow for cells, unless index and roughness are
// large enough. Along the normal the components across are small, and floats resolve any lobe.
TEST(SamplingDensity, OfRoughGlassWithAnIndexNextToOne) {
  for (const float eta : kIndicesNextToOne)
    for (const float alpha : kRoughnessesNextToOne)
      for (const float cosine : {1.0F, 0.7F}) {
        if (cosine < 1 && alpha * std::abs(eta - 1) < 0.9e-4F) continue;
        const Vec3f wo = view(cosine);
        const auto into = refracted(wo, Vec3f{0, 0, 1}, eta);
        const LogPolarMap map(cast<double>(into.value()), -32);
        const auto name = text_of("rough glass", alpha, cosine) + " eta " + std::to_string(eta);
        expect_density(test_of(RoughGlassBsdf<Rgb>{kWhite, eta, alpha}, wo, -1, map), name);
        expect_density(
            test_of(RoughDielectricBsdf<Rgb, 1>{boundary(eta), {alpha, false, false}}, wo, -1, map),
            "dielectric " + name);
      }
}

// An index of exactly 1 bends nothing: no light sample finds the way, and every path goes straight on.
TEST(SamplingDensity, OfRoughGlassWithAnIndexOfOneIsNone) {
  const RoughGlassBsdf<Rgb> glass{kWhite, 1, 0.1F};
  for (const float cosine : {1.0F, 0.7F, 0.2F, 0.02F}) {
    const Vec3f wo = view(cosine);
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const auto chosen = sample(glass, wo, four_uniform(i));
      if (!chosen) continue;
      ASSERT_TRUE(chosen->is_transmitted);
      EXPECT_EQ(chosen->pdf, 0);
      EXPECT_LT(length(chosen->wi + wo), 2e-7F);
      EXPECT_EQ(evaluate(glass, wo, chosen->wi).f_cos, Rgb{});
    }
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

namespace {

// Directions from the origin to a ball or ellipsoid above it.
void expect_density_of_ball(Vec3d centre, Vec3d radii) {
  SphereEmitter ball;
  ball.centre = centre;
  ball.axes = {Vec3d{radii.x, 0, 0}, Vec3d{0, radii.y, 0}, Vec3d{0, 0, radii.z}};
  ball.inverse = {Vec3d{1 / radii.x, 0, 0}, Vec3d{0, 1 / radii.y, 0}, Vec3d{0, 0, 1 / radii.z}};
  ball.determinant = radii.x * radii.y * radii.z;
  const LogPolarMap map({0, 1, 0});
  std::vector<Vec2d> points;
  for (std::uint64_t i = 0; i < kTrials; ++i) {
    const auto u = four_uniform(i);
    if (const auto point = sample_towards(EmitterShape(ball), {}, u[0], u[1]))
      points.push_back(map.point_of(cast<double>(point->position)));
  }
  // The ellipsoid |inverse p| = 1 along the direction; where it is missed there is no density.
  const auto density = [&](Vec2d p) {
    const Vec3d w = map.direction_of(p);
    const Vec3d inverse{1 / radii.x, 1 / radii.y, 1 / radii.z};
    const Vec3d o = -centre * inverse;
    const Vec3d d = w * inverse;
    const double b = dot(o, d);
    const double root = b * b - dot(d, d) * (dot(o, o) - 1);
    if (!(root > 0) || b > 0) return 0.0;
    const double t = (dot(o, o) - 1) / (-b + std::sqrt(root));
    return pdf_towards(EmitterShape(ball), {}, cast<float>(w * t)) * LogPolarMap::solid_angle_per_area(p);
  };
  expect_density(
      chi_square(points, kTrials, map.domain(), density),
      "ball of radius " + std::to_string(radii.x) + " at a distance of " + std::to_string(length(centre)));
}

}  // namespace

TEST(SamplingDensity, OfBalls) {
  for (const double distance : {1.0001, 1.01, 1.5, 10.0, 100.0})
    for (const Vec3d radii : {Vec3d{1, 1, 1}, Vec3d{0.5, 1, 0.7}})
      expect_density_of_ball({0, distance, 0}, radii);
}

// A metre below a ball of 1000 km, floats of the distance leave the height two digits, and the directions
// were off by several per cent.
TEST(SamplingDensity, OfBallsThatCoverTheSky) {
  for (const double radius : {1e4, 1e5, 1e6, 1e7})
    expect_density_of_ball({0, radius + 1, 0}, {radius, radius, radius});
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
  EXPECT_GT(test_with(right).p_value, tests::kDensityLevel);
  EXPECT_LT(test_with(shifted).p_value, tests::kDensityLevel);
  EXPECT_LT(test_with(elsewhere).p_value, tests::kDensityLevel);
}
