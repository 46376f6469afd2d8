#include "analytic/light_without_area.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using analytic::irradiance_of_lights;
using registry::AnalyticLight;
using registry::DirectLight;
using registry::FlatPolygon;

DirectLight lit_by(AnalyticLight light) {
  DirectLight image;
  image.lights = {std::move(light)};
  return image;
}

const Vec3d kUp{0, 1, 0};

TEST(AnalyticLights, FollowTheInverseSquareAndTheCosine) {
  const auto point = lit_by({.position = Vec3d{3, 4, 0}, .strength = 10});
  EXPECT_NEAR(irradiance_of_lights(point, {}, kUp, kUp), 10 * 4.0 / 125, 1e-14);
  EXPECT_EQ(irradiance_of_lights(point, {}, {0, -1, 0}, {0, -1, 0}), 0);
  const auto afar = lit_by({.position = {}, .direction = {0.6, -0.8, 0}, .strength = 10});
  EXPECT_NEAR(irradiance_of_lights(afar, {7, 0, -3}, kUp, kUp), 8, 1e-14);
}

// The table of angles between 15 and 30 degrees of the scene format.
TEST(AnalyticLights, FallOffInACone) {
  for (const auto& [degrees, share] : std::vector<std::pair<double, double>>{
           {15, 1}, {20, 0.82935}, {22.5, 0.61769}, {25, 0.35665}, {28, 0.07636}, {31, 0}}) {
    const double angle = degrees * std::numbers::pi / 180;
    const auto spot = lit_by({.position = Vec3d{0, 1, 0},
                              .direction = {std::sin(angle), -std::cos(angle), 0},
                              .strength = 1,
                              .cone_deg = std::array{15.0, 30.0}});
    EXPECT_NEAR(irradiance_of_lights(spot, {}, kUp, kUp), share, 1e-5) << degrees;
  }
  const auto hard = lit_by({.position = Vec3d{1, 1, 0}, .strength = 1, .cone_deg = std::array{44.9, 44.9}});
  EXPECT_EQ(irradiance_of_lights(hard, {}, kUp, kUp), 0);
}

TEST(AnalyticLights, FollowATableAboutTheirPlace) {
  const auto table = lit_by({.position = Vec3d{1, 1, 0}, .strength = 4, .candela = {{0, 1}, {90, 0}}});
  EXPECT_NEAR(irradiance_of_lights(table, {}, kUp, kUp), 4 * 0.5 / std::pow(2, 1.5), 1e-12);
}

TEST(AnalyticLights, AreHiddenByPolygonsBetweenAndByNoOthers) {
  auto scene = lit_by({.position = Vec3d{0, 2, 0}, .strength = 4});
  const auto card_at = [](double height) {
    return registry::AnalyticSurface{
        FlatPolygon{{{-1, height, 1}, {1, height, 1}, {1, height, -1}, {-1, height, -1}}}, 0, 0.5};
  };
  scene.has_shadows = true;
  scene.surfaces = {card_at(0), card_at(3), card_at(-1)};
  EXPECT_NEAR(irradiance_of_lights(scene, {}, kUp, kUp), 1, 1e-14);
  scene.surfaces.push_back(card_at(1));
  EXPECT_EQ(irradiance_of_lights(scene, {}, kUp, kUp), 0);
  EXPECT_GT(irradiance_of_lights(scene, {2.1, 0, 0}, kUp, kUp), 0);
}

}  // namespace
