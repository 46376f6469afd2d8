// Microfacet distributions: normalisation, sampling, and directional albedos in closed form.
#include "snippets/ggx.h"

#include <array>

#include <gtest/gtest.h>

namespace {

using namespace snippets;

// Any struct of three or two numbers serves as the vector type.
struct Vec {
  double x, y, z;
};
struct FloatVec {
  float x, y, z;
};
struct Point {
  double x, y;
};

constexpr double kPi = std::numbers::pi;

enum class Kind { Ggx, Beckmann };
constexpr std::array kKinds{Kind::Ggx, Kind::Beckmann};
constexpr std::array kAlphas{0.05, 0.2, 0.5, 1.0};
constexpr std::array kCosines{0.05, 0.3, 0.7, 1.0};

double d(Kind kind, Vec m, double alpha) {
  return kind == Kind::Ggx ? ggx_d(m, alpha) : beckmann_d(m, alpha);
}
double lambda(Kind kind, Vec w, double alpha) {
  return kind == Kind::Ggx ? ggx_lambda(w, alpha) : beckmann_lambda(w, alpha);
}
double visible_d(Kind kind, Vec wo, Vec m, double alpha) {
  return kind == Kind::Ggx ? ggx_visible_d(wo, m, alpha) : beckmann_visible_d(wo, m, alpha);
}
Vec sample_visible(Kind kind, Vec wo, double alpha, double u, double v) {
  if (kind == Kind::Beckmann) return sample_beckmann_visible(wo, alpha, u, v);
  const double radius = std::sqrt(u);
  return sample_ggx_visible(wo, alpha, Point{radius * std::cos(2 * kPi * v), radius * std::sin(2 * kPi * v)});
}

Vec direction(double cosine, double phi) {
  const double sine = std::sqrt(1 - cosine * cosine);
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

// Visits microfacet normals with the solid angle that each represents: slopes tan = alpha t / (1 - t),
// midpoints in t.
template <typename F>
void for_each_facet(double alpha, const F& visit) {
  constexpr int kRows = 240;
  constexpr int kColumns = 96;
  for (int row = 0; row < kRows; ++row) {
    const double t = (row + 0.5) / kRows;
    const double tangent = alpha * t / (1 - t);
    const double cosine = 1 / std::sqrt(1 + tangent * tangent);
    const double slope = alpha / ((1 - t) * (1 - t));  // d tan / dt
    const double solid_angle = slope * tangent * cosine * cosine * cosine * 2 * kPi / (kRows * kColumns);
    for (int column = 0; column < kColumns; ++column)
      visit(direction(cosine, 2 * kPi * (column + 0.5) / kColumns), solid_angle);
  }
}

double cosine_between(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// Mean weight of reflected samples, G2 / G1: the directional albedo of perfectly reflecting microfacets.
double furnace(Kind kind, double alpha, double cosine, bool correlated, int side) {
  const Vec wo = direction(cosine, 0.4);
  const double lambda_o = lambda(kind, wo, alpha);
  double sum = 0;
  for (int i = 0; i < side * side; ++i) {
    const Vec m = sample_visible(kind, wo, alpha, (i / side + 0.5) / side, (i % side + 0.5) / side);
    const double cos_o = cosine_between(wo, m);
    const Vec wi{2 * cos_o * m.x - wo.x, 2 * cos_o * m.y - wo.y, 2 * cos_o * m.z - wo.z};
    if (wi.z <= 0) continue;
    const double lambda_i = lambda(kind, wi, alpha);
    sum += (correlated ? smith_g2_correlated(lambda_o, lambda_i) : smith_g2_separable(lambda_o, lambda_i)) /
           smith_g1(lambda_o);
  }
  return sum / (side * side);
}

}  // namespace

TEST(Microfacets, FacetsCoverTheSurfaceOnce) {
  for (const Kind kind : kKinds)
    for (const double alpha : kAlphas) {
      double area = 0;
      for_each_facet(alpha,
                     [&](Vec m, double solid_angle) { area += solid_angle * d(kind, m, alpha) * m.z; });
      EXPECT_NEAR(area, 1, 1e-4) << alpha;
    }
}

// The projected area of the microfacets visible from w equals that of the surface, so their distribution is
// normalised; and samples have its means.
TEST(Microfacets, SamplesFollowTheDensityOfVisibleFacets) {
  constexpr int kSide = 100;
  using Moments = std::array<double, 6>;
  const auto moments = [](Vec m) { return Moments{1, m.x, m.y, m.z, m.x * m.x, m.x * m.y}; };
  for (const Kind kind : kKinds)
    for (const double alpha : kAlphas)
      for (const double cosine : kCosines) {
        const Vec wo = direction(cosine, 0.4);
        Moments of_density{};
        for_each_facet(alpha, [&](Vec m, double solid_angle) {
          if (cosine_between(wo, m) <= 0) return;
          const double share = solid_angle * visible_d(kind, wo, m, alpha);
          for (std::size_t i = 0; i < 6; ++i) of_density[i] += share * moments(m)[i];
        });
        Moments of_samples{};
        for (int i = 0; i < kSide * kSide; ++i) {
          const Vec m = sample_visible(kind, wo, alpha, (i / kSide + 0.5) / kSide, (i % kSide + 0.5) / kSide);
          for (std::size_t j = 0; j < 6; ++j) of_samples[j] += moments(m)[j] / (kSide * kSide);
        }
        EXPECT_NEAR(of_density[0], 1, 2e-3) << alpha << " " << cosine;
        for (std::size_t i = 0; i < 6; ++i)
          EXPECT_NEAR(of_samples[i], of_density[i], 4e-3) << alpha << " " << cosine << " moment " << i;
      }
}

// Directional albedo of GGX without Fresnel, single scattering, by quadrature of another program. At alpha =
// 1 and normal incidence, where multiple scattering is missed most, it is exactly 1 - ln 2 too low.
TEST(Microfacets, TheFurnaceOfGgxHasItsTable) {
  struct Row {
    double alpha, cosine, correlated, separable;
  };
  for (const auto& [alpha, cosine, correlated, separable] :
       {Row{0.1, 0.1, 0.8835, 0.8728}, Row{0.3, 0.5, 0.8217, 0.8181}, Row{0.5, 0.05, 0.9126, 0.7923},
        Row{0.5, 0.8, 0.6821, 0.6796}, Row{0.7, 0.3, 0.6692, 0.6147}, Row{1.0, 0.2, 0.6417, 0.5114},
        Row{1.0, 1.0, 0.3069, 0.3069}}) {
    EXPECT_NEAR(furnace(Kind::Ggx, alpha, cosine, true, 200), correlated, 4e-4) << alpha << " " << cosine;
    EXPECT_NEAR(furnace(Kind::Ggx, alpha, cosine, false, 200), separable, 4e-4) << alpha << " " << cosine;
  }
  EXPECT_NEAR(furnace(Kind::Ggx, 1, 1, true, 200), 1 - std::numbers::ln2, 2e-4);
}

TEST(Microfacets, TheFurnaceOfBeckmannMakesNoLight) {
  for (const double alpha : kAlphas)
    for (const double cosine : kCosines) {
      const double correlated = furnace(Kind::Beckmann, alpha, cosine, true, 40);
      EXPECT_LT(correlated, 1 + 1e-9);
      EXPECT_LE(furnace(Kind::Beckmann, alpha, cosine, false, 40), correlated + 1e-12);
    }
  EXPECT_GT(furnace(Kind::Beckmann, 0.05, 1, true, 40), 0.99);
}

TEST(Microfacets, FloatsFollowDoubles) {
  for (const double alpha : {1e-3, 0.05, 0.5, 1.0})
    for (const double cosine : {0.01, 0.3, 0.999})
      for (double u = 0.01; u < 1; u += 0.07) {
        const Vec wo = direction(cosine, 1.1);
        const FloatVec narrow{static_cast<float>(wo.x), static_cast<float>(wo.y), static_cast<float>(wo.z)};
        const auto a = static_cast<float>(alpha);
        const Vec m = sample_beckmann_visible(wo, alpha, u, 1 - u);
        const FloatVec n =
            sample_beckmann_visible(narrow, a, static_cast<float>(u), static_cast<float>(1 - u));
        EXPECT_NEAR(n.x, m.x, 1e-4);
        EXPECT_NEAR(n.y, m.y, 1e-4);
        EXPECT_NEAR(n.z, m.z, 1e-4);
        EXPECT_NEAR(ggx_lambda(narrow, a), ggx_lambda(wo, alpha), 1e-4 * (1 + ggx_lambda(wo, alpha)));
        EXPECT_NEAR(beckmann_lambda(narrow, a), beckmann_lambda(wo, alpha),
                    1e-4 * (1 + beckmann_lambda(wo, alpha)));
      }
}

TEST(Microfacets, EveryNumberGivesAFacetAboveTheHorizon) {
  for (const double alpha : {1e-4, 0.3, 1.0})
    for (const double cosine : {1e-6, 0.01, 1.0})
      for (const float u : {0.0F, 0x1p-24F, 0.5F, 1 - 0x1p-24F})
        for (const float v : {0.0F, 0x1p-24F, 0.5F, 1 - 0x1p-24F}) {
          const Vec wo = direction(cosine, 0);
          const FloatVec narrow{static_cast<float>(wo.x), static_cast<float>(wo.y), static_cast<float>(wo.z)};
          const FloatVec m = sample_beckmann_visible(narrow, static_cast<float>(alpha), u, v);
          EXPECT_GT(m.z, 0);
          EXPECT_NEAR(m.x * m.x + m.y * m.y + m.z * m.z, 1, 1e-6);
        }
}
