// White furnace tests: lossless objects in a uniform environment must be invisible. Models that lose energy
// by design, as single-scattering microfacets do, are tested against their integral.
#include "property/light_images.h"
#include "property/light_quadrature.h"

#include <complex>
#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::tests;

const View kBall{.fov_deg = 24, .width = 16, .height = 16};  // a ball of radius 1 fills the image

// An analytic ball of the material in a D65 environment.
std::string ball(const std::string& material, const std::string& more = "") {
  return scene_of(
      kBall, R"("environment": [1, 1, 1], "materials": [{"name": "m", )" + material +
                 R"(}], "shapes": [{"type": "sphere", "centre": [0, 0, 0], "radius": 1, "material": "m"}])" +
                 more);
}

const std::string kStokes = R"(, "outputs": {"stokes": true})";
const std::string kFlint = R"({"file": "data/common/spectra/glasses_sellmeier.csv", "material": "SF10"})";

tracer::WorldSettings with(scene::LightTransport transport) { return {.transport = transport}; }

void expect_white(const image::Image& image, const std::string& what) {
  for (std::size_t channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(mean_of_channel(image, channel), 1, 4 * error_of_mean(image, channel) + 1e-5)
        << what << " channel " << channel;
}

// Light inside and outside is in equilibrium, hence unpolarised.
void expect_unpolarised(const image::Image& image, const std::string& what) {
  for (const char* channel : {"S1.R", "S1.G", "S1.B", "S2.R", "S2.G", "S2.B", "S3.R", "S3.G", "S3.B"}) {
    const auto s = estimate_of(image, channel);
    EXPECT_NEAR(s.mean, 0, 4 * s.error + 1e-6) << what << " " << channel;
  }
}

// Of the luminance, because the matching function of Y is nowhere negative. Those of R are, so that its
// degree of polarisation is unbounded if the polarisation depends on the wavelength.
double largest_degree_of_polarisation(const image::Image& image) {
  double largest = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      std::array<double, 4> s{};
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t at = channel_of(image, fmt::format("S{}.R", k));
        s[k] = luminance_by_sum({image.at(x, y, at), image.at(x, y, at + 1), image.at(x, y, at + 2)});
      }
      largest = std::max(largest, std::hypot(s[1], s[2], s[3]) / s[0]);
    }
  return largest;
}

}  // namespace

// Every scattering event has weight 1, so each path contributes exactly as much as without the ball.
TEST(LightFurnace, ASmoothGlassBallOfOneIndexIsNotThereAtAll) {
  const auto empty = scene_of(kBall, R"("environment": [1, 1, 1], "materials": [])");
  for (const auto transport :
       {scene::LightTransport::Rgb, scene::LightTransport::Spectral, scene::LightTransport::Bispectral}) {
    const auto bare = image_of(empty, 4, with(transport));
    const auto glass = image_of(ball(R"("type": "dielectric", "index": 1.5)"), 4, with(transport));
    for (int y = 0; y < bare.height; ++y)
      for (int x = 0; x < bare.width; ++x)
        for (std::size_t channel = 0; channel < 3; ++channel)
          ASSERT_NEAR(glass.at(x, y, channel), bare.at(x, y, channel), 1e-4)
              << scene::transport_name(transport) << " " << x << " " << y;
  }
}

TEST(LightFurnace, ASmoothBallThatDispersesIsInvisible) {
  expect_white(image_of(ball(R"("type": "dielectric", "index": )" + kFlint), 256), "SF10");
}

TEST(LightFurnace, AFilmedBallIsInvisible) {
  const std::string film = R"("type": "dielectric", "index": 1.5, "film": {"index": 1.33, "height_nm": 400})";
  expect_white(image_of(ball(film), 256), "spectral");
  const auto polarised = image_of(ball(film, kStokes), 256);
  expect_white(polarised, "polarised");
  expect_unpolarised(polarised, "film");
  EXPECT_LE(largest_degree_of_polarisation(polarised), 1 + 1e-5);
}

TEST(LightFurnace, SmoothBallsStayInvisibleWithPolarisation) {
  for (const std::string& index : {std::string("1.5"), kFlint}) {
    const auto image = image_of(ball(R"("type": "dielectric", "index": )" + index, kStokes), 256);
    expect_white(image, index);
    expect_unpolarised(image, index);
    EXPECT_LE(largest_degree_of_polarisation(image), 1 + 1e-5) << index;
  }
}

// In an environment that is dark on one side nearly everything is polarised, with one sample per pixel
// completely.
TEST(LightFurnace, NoPixelIsMorePolarisedThanLightCanBe) {
  const std::string lamp =
      R"("lights": [{"type": "rect", "half_width": 2, "half_length": 2, "radiance": [5, 5, 5], "matrix": [{"translate": [1, 4, 1]}]}], )";
  for (const std::string material :
       {R"("type": "dielectric", "index": 1.5)", R"("type": "dielectric", "index": 1.5, "alpha": 0.2)",
        R"("type": "conductor", "index": {"n": 0.2, "k": 3.4}, "alpha": 0.2)",
        R"("type": "dielectric", "index": 1.5, "film": {"index": 2.2, "height_nm": 300})",
        R"("type": "glass", "ior": 1.5)", R"("type": "rough_glass", "ior": 1.5, "alpha": 0.3)"})
    for (const int samples : {1, 16}) {
      const auto text = scene_of(
          kBall,
          lamp + R"("environment": [0.01, 0.01, 0.01], "materials": [{"name": "m", )" + material +
              R"(}], "shapes": [{"type": "sphere", "centre": [0, 0, 0], "radius": 1, "material": "m"}])" +
              kStokes);
      EXPECT_LE(largest_degree_of_polarisation(image_of(text, samples)), 1 + 1e-4) << material;
    }
}

namespace {

struct RoughSurface {
  double alpha = 0.3;
  bool is_beckmann = false;
  bool is_correlated = false;
};

double lambda_of(const RoughSurface& glass, double cosine) {
  const double slope = std::sqrt(1 - cosine * cosine) / cosine;  // tan
  if (slope == 0) return 0;
  if (!glass.is_beckmann) return (std::sqrt(1 + glass.alpha * glass.alpha * slope * slope) - 1) / 2;
  const double a = 1 / (glass.alpha * slope);
  return (std::erf(a) - 1) / 2 + std::exp(-a * a) / (2 * a * std::sqrt(std::numbers::pi));
}

// Masking function of one side; nothing is masked on the other.
double both_seen(const RoughSurface& glass, double lambda_o, double cosine_i) {
  const double lambda_i = lambda_of(glass, std::abs(cosine_i));
  return glass.is_correlated ? 1 / (1 + lambda_o + lambda_i) : 1 / ((1 + lambda_o) * (1 + lambda_i));
}

using Complex = std::complex<double>;

double fresnel(double cos_i, Complex eta) {
  const Complex beyond = std::sqrt(eta * eta - 1.0 + cos_i * cos_i);
  return (std::norm((cos_i - beyond) / (cos_i + beyond)) +
          std::norm((eta * eta * cos_i - beyond) / (eta * eta * cos_i + beyond))) /
         2;
}

// Radiance of the surface in direction `cosine` if the incident radiance is 1 on both sides; index: beyond
// over this side, complex for metals. Walter et al. 2007 by microfacets: slopes are distributed as D cos,
// weighted by their visibility.
double radiance_by_quadrature(const RoughSurface& glass, double cosine, Complex index) {
  const double eta = index.real();
  constexpr int kSteps = 400;
  const Vec3d o{std::sqrt(1 - cosine * cosine), 0, cosine};
  const double lambda_o = lambda_of(glass, cosine);
  double sum = 0;
  for (int i = 0; i < kSteps; ++i)
    for (int k = 0; k < kSteps; ++k) {
      // From the cumulative distribution 1 - left^2, which has no singularity at grazing facets.
      const double left = (i + 0.5) / kSteps;
      const double u = 1 - left * left;
      const double phi = std::numbers::pi * (k + 0.5) / kSteps;  // the other half is the same
      const double slope = glass.alpha * std::sqrt(glass.is_beckmann ? -std::log(1 - u) : u / (1 - u));
      const double cos_m = 1 / std::sqrt(1 + slope * slope);
      const Vec3d m{slope * cos_m * std::cos(phi), slope * cos_m * std::sin(phi), cos_m};
      const double cos_o = dot(o, m);
      if (cos_o <= 0) continue;
      const double seen = 2 * left * cos_o / (cosine * cos_m);  // times the masking, below
      const double reflected = fresnel(cos_o, index);
      const double up = 2 * cos_o * m.z - o.z;
      if (up > 0) sum += seen * reflected * both_seen(glass, lambda_o, up);
      // Nothing is transmitted from a metal or through a facet with total reflection.
      if (index.imag() > 0 || 1 - cos_o * cos_o >= eta * eta) continue;
      const double beyond = std::sqrt(1 - (1 - cos_o * cos_o) / (eta * eta));
      const double down = (cos_o / eta - beyond) * m.z - o.z / eta;
      if (down < 0) sum += seen * (1 - reflected) * both_seen(glass, lambda_o, down) / (eta * eta);
    }
  return sum / (kSteps * kSteps);
}

}  // namespace

// Microfacets that reflect everything: independent numbers.
TEST(LightFurnace, TheIntegralOverFacetsHasTheKnownValues) {
  constexpr double kMirror = 1e9;
  EXPECT_NEAR(radiance_by_quadrature({1.0, false, false}, 0.5, kMirror), 0.4091, 1e-4);
  EXPECT_NEAR(radiance_by_quadrature({0.3, false, false}, 0.5, kMirror), 0.8181, 1e-4);
  EXPECT_NEAR(radiance_by_quadrature({0.3, false, true}, 0.5, kMirror), 0.8217, 1e-4);
  EXPECT_NEAR(radiance_by_quadrature({0.5, false, true}, 0.5, kMirror), 0.6982, 1e-4);
}

// One boundary between two half-spaces of radiance 1, seen from outside and from inside.
TEST(LightFurnace, RoughGlassShowsWhatItsFacetsSee) {
  for (const RoughSurface glass :
       {RoughSurface{0.3, false, false}, RoughSurface{0.3, false, true}, RoughSurface{0.4, true, false}})
    for (const bool is_outside : {true, false}) {
      const auto text = scene_of(
          {.position = is_outside ? "[8.660254037844386, 0, 5]" : "[8.660254037844386, 0, -5]"},
          fmt::format(
              R"("environment": [1, 1, 1], "materials": [{{"name": "m", "type": "dielectric", "index": 1.5, "alpha": {}, "distribution": "{}", "masking": "{}"}}], {})",
              glass.alpha, glass.is_beckmann ? "beckmann" : "ggx",
              glass.is_correlated ? "correlated" : "separable",
              meshes({square({0, 0, 0}, {0, 0, 1}, 1, "m")})),
          "1");
      const double expected = radiance_by_quadrature(glass, 0.5, is_outside ? 1.5 : 1 / 1.5);
      for (const auto transport :
           {scene::LightTransport::Rgb, scene::LightTransport::Spectral, scene::LightTransport::Polarised}) {
        const auto image = image_of(text, 1024, with(transport));
        const double error = error_of_mean(image, 1);
        EXPECT_NEAR(mean_of_channel(image, 1), expected, 4 * error + 1e-4 * expected)
            << scene::transport_name(transport) << " alpha " << glass.alpha
            << (is_outside ? " outside" : " inside");
        EXPECT_LT(error, 0.005);
      }
    }
}

TEST(LightFurnace, RoughMetalShowsWhatItsFacetsSee) {
  for (const RoughSurface metal :
       {RoughSurface{0.5, false, false}, RoughSurface{0.5, false, true}, RoughSurface{0.3, true, true}}) {
    const auto text = scene_of(
        {.position = "[8.660254037844386, 0, 5]"},
        fmt::format(
            R"("environment": [1, 1, 1], "materials": [{{"name": "m", "type": "conductor", )"
            R"("index": {{"n": 2.9, "k": 3.0}}, "alpha": {}, "distribution": "{}", "masking": "{}"}}], {})",
            metal.alpha, metal.is_beckmann ? "beckmann" : "ggx",
            metal.is_correlated ? "correlated" : "separable", meshes({square({0, 0, 0}, {0, 0, 1}, 1, "m")})),
        "1");
    const double expected = radiance_by_quadrature(metal, 0.5, {2.9, 3.0});
    for (const auto transport :
         {scene::LightTransport::Rgb, scene::LightTransport::Spectral, scene::LightTransport::Polarised}) {
      const auto image = image_of(text, 256, with(transport));
      const double error = error_of_mean(image, 1);
      EXPECT_NEAR(mean_of_channel(image, 1), expected, 4 * error + 1e-4 * expected)
          << scene::transport_name(transport) << " alpha " << metal.alpha;
      EXPECT_LT(error, 0.002);
    }
  }
}
