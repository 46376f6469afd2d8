// Images that follow from a formula, and the closed forms behind them.
#include "analytic/analytic_image.h"
#include "analytic/plastic.h"
#include "analytic/reflectance.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

double cosine_of(double angle) { return std::cos(angle * std::numbers::pi / 180); }

scene::Camera camera(Vec3d position, Vec3d look_at, double fov_y, int size) {
  scene::Camera made;
  made.position_m = position;
  made.look_at_m = look_at;
  made.fov_y_deg = fov_y;
  made.width_px = made.height_px = size;
  return made;
}

}  // namespace

TEST(AnalyticImage, FresnelReflectanceIsTheTabulated) {
  EXPECT_NEAR(analytic::fresnel_reflectance(1, 1.5, 0), 0.04, 1e-12);
  EXPECT_NEAR(analytic::fresnel_reflectance(cosine_of(30), 1.5, 0), 0.041523, 1e-6);
  EXPECT_NEAR(analytic::fresnel_reflectance(cosine_of(75), 1.5, 0), 0.253061, 1e-6);
  EXPECT_NEAR(analytic::fresnel_reflectance(1, 2.9, 3), 0.52085915, 1e-8);
  EXPECT_NEAR(analytic::fresnel_reflectance(cosine_of(42), 1 / 1.5, 0), 1, 1e-12);
  EXPECT_LT(analytic::fresnel_reflectance(cosine_of(41.5), 1 / 1.5, 0), 0.7);
}

TEST(AnalyticImage, PlatesTransmitWhatTheyReflectBetweenThem) {
  const auto at = [](double angle, int plates) {
    const registry::FresnelPlane image{{0, 0, 1}, {1.5, 1.5, 1.5}, {}, 1, plates};
    return analytic::fresnel_plane(image,
                                   {{}, {std::sin(angle * std::numbers::pi / 180), 0, -cosine_of(angle)}})[0];
  };
  EXPECT_NEAR(at(0, 1), 0.923077, 1e-6);
  EXPECT_NEAR(at(60, 1), 0.836232, 1e-6);
  EXPECT_NEAR(at(75, 1), 0.596092, 1e-6);
  EXPECT_NEAR(at(0, 3), 0.8, 1e-9);
}

TEST(AnalyticImage, DirectionalAlbedosAreTheTabulated) {
  EXPECT_NEAR(analytic::oren_nayar_albedo(0.5, 0), 0.674262, 1e-6);
  EXPECT_NEAR(analytic::oren_nayar_albedo(0.5, std::numbers::pi / 3), 0.791338, 1e-6);
  EXPECT_NEAR(analytic::oren_nayar_albedo(1. / 9, std::numbers::pi / 2), 1.014643, 1e-6);
  const auto ggx_albedo = [](double alpha, double cosine) {
    return analytic::directional_albedo(analytic::ggx_brdf(alpha), cosine);
  };
  EXPECT_NEAR(ggx_albedo(1, 1), 1 - std::numbers::ln2, 1e-6);
  EXPECT_NEAR(ggx_albedo(0.5, 0.5), 0.6982, 1e-4);
  EXPECT_NEAR(ggx_albedo(0.5, 0.05), 0.9126, 1e-4);
  EXPECT_NEAR(ggx_albedo(0.1, 0.5), 0.9692, 1e-4);
}

// Computed once more by quadrature in another language.
TEST(AnalyticImage, AlbedosOfMetallicAndRoughnessAreTheTabulated) {
  const auto albedo = [](double base, double metallic, double roughness, double cosine) {
    return analytic::directional_albedo(analytic::metallic_roughness_brdf(base, metallic, roughness), cosine);
  };
  EXPECT_NEAR(albedo(0.5, 0, 0.5, 0.1), 0.62617, 2e-5);
  EXPECT_NEAR(albedo(0.5, 0, 0.5, 1), 0.51662, 2e-5);
  EXPECT_NEAR(albedo(0.5, 1, 0.5, 0.3), 0.44685, 2e-5);
  EXPECT_NEAR(albedo(0.5, 1, 0.5, 1), 0.45792, 2e-5);
  EXPECT_NEAR(albedo(0.5, 0, 1, 0.5), 0.49634, 2e-5);
  EXPECT_NEAR(albedo(1, 0, 0.32, 0.1), 1.25336, 5e-4) << "more light than arrives";
}

// Along the normal the lobe and the cosine are one power: k (n + 2) times the integral of cos^(n + 1), which
// is k. Elsewhere by quadrature in another language.
TEST(AnalyticImage, AlbedosOfPhongAreTheTabulated) {
  const auto albedo = [](double exponent, double cosine) {
    return analytic::directional_albedo(analytic::phong_brdf(1, exponent), cosine);
  };
  for (const double exponent : {0.0, 1.0, 10.0, 50.0}) EXPECT_NEAR(albedo(exponent, 1), 1, 1e-6);
  EXPECT_NEAR(albedo(1, 0.8), 0.82712, 2e-5);
  EXPECT_NEAR(albedo(1, 0.2), 0.42470, 2e-5);
  EXPECT_NEAR(albedo(10, 0.5), 0.50474, 2e-5);
  EXPECT_NEAR(albedo(50, 0.2), 0.20472, 2e-5);
}

// F + (1 - F) rho by Fresnel's formula; with reflections inside that take the base's colour less. Computed
// once more by quadrature in another language.
TEST(AnalyticImage, AlbedosOfSmoothPlasticAreTheTabulated) {
  EXPECT_NEAR(analytic::fresnel_of_diffuse_light(1.5), 0.0917780, 1e-7);
  EXPECT_NEAR(analytic::fresnel_of_diffuse_light(1.9), 0.1474755, 1e-7);
  const analytic::PlasticAlbedo linear({0.5, 1.5, false, 0});
  EXPECT_NEAR(linear.reflected_inside(), 0.5963458, 1e-7);
  EXPECT_NEAR(linear.at(0.1), 0.785796, 1e-6);
  EXPECT_NEAR(linear.at(0.7071), 0.525120, 1e-6);
  const analytic::PlasticAlbedo nonlinear({0.5, 1.5, true, 0});
  EXPECT_NEAR(nonlinear.at(0.3), 0.435585, 1e-6);
  EXPECT_NEAR(nonlinear.at(1), 0.316071, 1e-6);
  for (const bool is_nonlinear : {false, true})
    for (const double cosine : {0.05, 0.5, 1.0})
      EXPECT_NEAR(analytic::PlasticAlbedo({1, 1.5, is_nonlinear, 0}).at(cosine), 1, 1e-9)
          << "white stays white";
}

TEST(AnalyticImage, AlbedosOfRoughPlasticAreTheTabulated) {
  const analytic::PlasticAlbedo linear({0.5, 1.5, false, 0.1});
  EXPECT_NEAR(linear.reflected_inside(), 0.56002, 5e-5);
  EXPECT_NEAR(linear.at(0.1), 0.58718, 1e-4);
  EXPECT_NEAR(linear.at(0.5), 0.50396, 1e-4);
  EXPECT_NEAR(linear.at(1), 0.48210, 1e-4);
  const analytic::PlasticAlbedo wide({0.5, 1.5, false, 0.3});
  EXPECT_NEAR(wide.at(0.3), 0.37460, 1e-4);
  EXPECT_NEAR(wide.at(0.7071), 0.36603, 1e-4);
}

// Of reflectance 1 a metal is the ggx without a Fresnel factor. Of reflectance 0 a smooth one would show
// Schlick's weight (1 - cos)^5; at alpha 0.1 it is that but for the width of the lobe.
TEST(AnalyticImage, AlbedosOfMetalsLieBetweenTheirLimits) {
  for (const double cosine : {0.1, 0.5, 1.0})
    EXPECT_NEAR(analytic::directional_albedo(analytic::metal_brdf(1, 0.4), cosine),
                analytic::directional_albedo(analytic::ggx_brdf(0.4), cosine), 1e-12);
  EXPECT_NEAR(analytic::directional_albedo(analytic::metal_brdf(0, 0.1), 0.5), std::pow(0.5, 5), 2e-3);
}

// The lamps of the emission scene: on both edges of a ground, 0 and 1.9 m from its middle.
TEST(AnalyticImage, EmissionIsTheSumOfItsTwoLamps) {
  registry::DirectLight image;
  image.surfaces = {{registry::FlatPolygon{{{-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2}}}, 0, 0.5}};
  image.sources.push_back(
      {registry::FlatPolygon{{{-2, 0, -.5}, {-2, 1, -.5}, {-2, 1, .5}, {-2, 0, .5}}}, 1, {}, {}, {}});
  image.sources.push_back(
      {registry::FlatPolygon{{{2, 0, -.5}, {2, 0, .5}, {2, 1, .5}, {2, 1, -.5}}}, 1, {}, {}, {}});
  const auto at = [&](double x, double z) {
    auto view = camera({x, 1, z}, {x, 0, z}, 1e-3, 1);
    view.up = {0, 0, -1};
    return static_cast<double>(analytic::analytic_image(image, view).pixels[0]);
  };
  EXPECT_NEAR(at(0, 0), 0.01534745, 1e-7);
  EXPECT_NEAR(at(1, 0), 0.03815372, 1e-7);
  EXPECT_NEAR(at(-1.9, 0), 0.21251801, 1e-6);
  EXPECT_NEAR(at(-1.5, .5), 0.06376646, 1e-7);
}

// A pixel is the mean over its square: a disk of radius r covers pi r^2 / 4 of a square of side 2.
TEST(AnalyticImage, PixelsAreMeansOverTheirSquares) {
  registry::DirectLight image;
  image.surfaces = {{registry::FormulaSphere{{0, 0, 0}, 0.5}, 1, {}}};
  const auto view = camera({0, 0, 1000}, {0, 0, 0}, 2 * std::atan(1. / 1000) * 180 / std::numbers::pi, 1);
  EXPECT_NEAR(static_cast<double>(analytic::analytic_image(image, view).pixels[0]), std::numbers::pi / 16,
              1e-4);
}

TEST(AnalyticImage, MirrorsDarkenByEachReflection) {
  const registry::MirrorCorridor corridor{1, -1, 0.9};
  const auto along = [&](double x) {
    return static_cast<double>(
        analytic::analytic_image(corridor, camera({0, 0, 0}, {x, -1, -0.1}, 0.1, 1)).pixels[0]);
  };
  EXPECT_NEAR(along(0.5), 1, 1e-7);
  EXPECT_NEAR(along(1.5), 0.9, 1e-7);
  EXPECT_NEAR(along(-3.5), 0.81, 1e-7);
}

// Ambient occlusion: white surfaces under a white sky that hide it from each other, and never from
// themselves.
TEST(AnalyticImage, SurfacesThatAreSourcesTooHideTheSkyFromOthersAlone) {
  const auto square = [](double half) {
    return registry::FlatPolygon{{{-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half}}};
  };
  const auto at = [](const registry::AnalyticShape& floor, const registry::AnalyticShape& body, Vec3d from,
                     Vec3d to) {
    registry::DirectLight image;
    image.environment = 1;
    image.surfaces = {{floor, 0, 1}, {body, 0, 1}};
    image.sources = {{floor, 0, {}, {}, {}}, {body, 0, {}, {}, {}}};
    auto view = camera(from, to, 1e-4, 1);
    view.up = {0, 0.1, -1};
    return static_cast<double>(analytic::analytic_image(image, view).pixels[0]);
  };
  const registry::FlatPolygon wall{{{0, 0, 5000}, {0, 0, -5000}, {0, 1, -5000}, {0, 1, 5000}}};
  EXPECT_NEAR(at(square(4), wall, {1, 9, 0}, {1, 0, 0}), (1 + 1 / std::sqrt(2.0)) / 2, 1e-6);
  EXPECT_NEAR(at(square(1e4), wall, {9, 0.5, 0}, {0, 0.5, 0}), 0.5, 1e-4);
  // 1 - (1 + x^2)^(-3/2) beside a sphere that rests on the floor; its own side sees half of the floor.
  const registry::FormulaSphere ball{{0, 1, 0}, 1};
  EXPECT_NEAR(at(square(4), ball, {2, 9, 0}, {2, 0, 0}), 1 - std::pow(5.0, -1.5), 1e-6);
  EXPECT_NEAR(at(square(1e6), ball, {9, 1, 0}, {1, 1, 0}), 0.5, 1e-4);
  EXPECT_NEAR(at(square(4), ball, {0, 9, 0}, {0, 2, 0}), 1, 1e-6);
}
