// Lobes of smooth microfacets at grazing views are a few floats wide across the view: directions in single
// precision resolve them no more than cells of a chi-square test could. So their facets are tested in double,
// and the floats against these; and light sampling and BSDF sampling must find the same light by them.
#include "property/hashed_numbers.h"
#include "property/light_images.h"
#include "property/sampling_density.h"
#include "snippets/ggx.h"
#include "tracer/bsdf/materials.h"
#include "tracer/sampling/warps.h"

#include <numbers>
#include <string>

#include <fmt/format.h>

namespace {

using namespace orbs;
using namespace orbs::tracer;
using tests::chi_square;
using tests::expect_density;
using tests::four_uniform;
using tests::kTrials;
using tests::LogPolarMap;

// Those that SamplingDensity.OfRoughReflection leaves out, and narrower ones.
struct Lobe {
  double alpha = 0;
  double cosine = 0;
};
constexpr std::array kNarrowLobes{Lobe{1e-4, 0.02}, Lobe{1e-4, 0.002}, Lobe{1e-3, 0.002}, Lobe{1e-4, 1e-4},
                                  Lobe{1e-3, 1e-5}, Lobe{0.01, 1e-4},  Lobe{0.1, 1e-5}};

Vec3d view(double cosine) {
  const double sine = std::sqrt(1 - cosine * cosine);
  return {sine * 0.8, sine * 0.6, cosine};
}

std::string name_of(const Lobe& lobe) { return fmt::format("alpha {} cos {}", lobe.alpha, lobe.cosine); }

template <typename V>
V facet(bool is_beckmann, V wo, double alpha, const std::array<float, 4>& u) {
  using Real = decltype(wo.x);
  const auto a = static_cast<Real>(alpha);
  if (is_beckmann)
    return snippets::sample_beckmann_visible(wo, a, static_cast<Real>(u[0]), static_cast<Real>(u[1]));
  const Vec2f disk = sample_disk(u[0], u[1]);
  return snippets::sample_ggx_visible(wo, a,
                                      Vec2<Real>{static_cast<Real>(disk.x), static_cast<Real>(disk.y)});
}

template <typename V>
double facet_density(bool is_beckmann, V wo, V m, double alpha) {
  using Real = decltype(wo.x);
  if (!(dot(wo, m) > 0)) return 0;
  const auto a = static_cast<Real>(alpha);
  return static_cast<double>(is_beckmann ? snippets::beckmann_visible_d(wo, m, a)
                                         : snippets::ggx_visible_d(wo, m, a));
}

}  // namespace

TEST(NarrowLobes, FacetsFollowTheDensityThatTheyState) {
  for (const Lobe& lobe : kNarrowLobes)
    for (const bool is_beckmann : {false, true}) {
      const Vec3d wo = view(lobe.cosine);
      const LogPolarMap map({0, 0, 1}, -32);
      std::vector<Vec2d> points;
      for (std::uint64_t i = 0; i < kTrials; ++i)
        points.push_back(map.point_of(facet(is_beckmann, wo, lobe.alpha, four_uniform(i))));
      expect_density(chi_square(points, kTrials, map.domain(),
                                [&](Vec2d p) {
                                  return facet_density(is_beckmann, wo, map.direction_of(p), lobe.alpha) *
                                         LogPolarMap::solid_angle_per_area(p);
                                }),
                     (is_beckmann ? "beckmann " : "ggx ") + name_of(lobe));
    }
}

// Relative to how far from the normal it lies, and to the width of the lobe: rounding moves a facet by next
// to nothing, and with it the density that a sample states.
TEST(NarrowLobes, FacetsOfFloatsAreThoseOfDoubles) {
  for (const Lobe& lobe : kNarrowLobes)
    for (const bool is_beckmann : {false, true}) {
      const Vec3d wo = view(lobe.cosine);
      const Vec3f narrow = cast<float>(wo);
      double largest = 0;
      double largest_of_density = 0;
      for (std::uint64_t i = 0; i < kTrials; ++i) {
        const auto u = four_uniform(i);
        const Vec3d m = facet(is_beckmann, wo, lobe.alpha, u);
        const Vec3f n = facet(is_beckmann, narrow, lobe.alpha, u);
        const double off = std::hypot(static_cast<double>(n.x) - m.x, static_cast<double>(n.y) - m.y);
        largest = std::max(largest, off / (lobe.alpha + std::hypot(m.x, m.y)));
        const double density = facet_density(is_beckmann, wo, m, lobe.alpha);
        const double of_floats = facet_density(is_beckmann, narrow, n, lobe.alpha);
        largest_of_density = std::max(largest_of_density, std::abs(of_floats / density - 1));
      }
      EXPECT_LT(largest, 2e-3) << is_beckmann << " " << name_of(lobe);
      EXPECT_LT(largest_of_density, 5e-3) << is_beckmann << " " << name_of(lobe);
    }
}

namespace {

// A floor, seen at a grazing angle, in which a lamp a metre behind it is reflected that is twice as wide and
// twice as high as what the lobe blurs a point to: 2 alpha along the view and 2 alpha times the cosine across
// it.
std::string floor_and_lamp(const Lobe& lobe, const std::string& material) {
  const double sine = std::sqrt(1 - lobe.cosine * lobe.cosine);
  const tests::View view{.position = tests::text_of({-0.01 * sine, 0.01 * lobe.cosine, 0}), .fov_deg = 0.001};
  return tests::scene_of(
      view,
      fmt::format(
          R"("materials": [{}], {}, "lights": [{{"type": "rect", "half_width": {}, "half_length": {},
             "radiance": [1, 1, 1], "matrix": [{{"translate": [{}, {}, 0]}}, {{"rotate_z": -90}}]}}])",
          material, tests::meshes({tests::square({0, 0, 0}, {0, 1, 0}, 3, "floor")}), 2 * lobe.alpha,
          2 * lobe.alpha * lobe.cosine, sine, lobe.cosine),
      "1");
}

}  // namespace

// The direction to a light is rounded to a part of the lobe, in light samples and in BSDF samples alike. Each
// technique alone, and both by multiple importance sampling, find the same light.
TEST(NarrowLobes, ShowTheSameLightByEitherTechnique) {
  using tracer::DirectLight;
  for (const Lobe& lobe : {Lobe{1e-4, 0.02}, Lobe{1e-4, 0.002}, Lobe{1e-3, 0.002}})
    for (const char* kind : {R"("type": "ggx", "colour": [1, 1, 1])",
                             R"("type": "conductor", "index": {"n": 0.06, "k": 3.6})"}) {
      const auto text =
          floor_and_lamp(lobe, fmt::format(R"({{"name": "floor", {}, "alpha": {}}})", kind, lobe.alpha));
      const auto image_by = [&](DirectLight technique) {
        return tests::image_of(text, 8192, {.light_paths = false, .direct_light = technique});
      };
      const auto both = image_by(DirectLight::Mis);
      const double expected = tests::mean_of_channel(both, 0);
      EXPECT_GT(expected, 0.02) << "the lamp is not seen: " << name_of(lobe);
      for (const auto technique : {DirectLight::Bsdf, DirectLight::Light}) {
        const auto alone = image_by(technique);
        const double error = std::hypot(tests::error_of_mean(both, 0), tests::error_of_mean(alone, 0));
        EXPECT_LT(error, 0.01 * expected) << "too noisy to tell";
        EXPECT_NEAR(tests::mean_of_channel(alone, 0), expected, 4 * error + 2e-3 * expected) << name_of(lobe);
      }
    }
}
