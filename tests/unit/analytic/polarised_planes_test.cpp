// Light that planes polarise, against what textbooks say of it.
#include "analytic/polarised_planes.h"

#include "analytic/analytic_image.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr double kRadians = std::numbers::pi / 180;

// Of a camera that looks along -z with x to the right; the plane is met at this angle and mirrors the ray
// upwards where the azimuth is 0, turned counter-clockwise by it.
Vec3d plane_normal(double angle_deg, double azimuth_deg) {
  const double sine = std::sin(angle_deg * kRadians);
  return {-sine * std::sin(azimuth_deg * kRadians), sine * std::cos(azimuth_deg * kRadians),
          std::cos(angle_deg * kRadians)};
}

std::array<double, 4> stokes(const std::vector<registry::PolarisedPlane>& planes) {
  return analytic::polarised_planes({planes, 1}, {{}, {0, 0, -1}}, {1, 0, 0});
}

void expect_stokes(const std::array<double, 4>& found, const std::array<double, 4>& expected) {
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found.at(i), expected.at(i), 1e-9) << 'S' << i;
}

}  // namespace

// At Brewster's angle all of it is s, half of ((n^2 - 1) / (n^2 + 1))^2, across the plane of incidence.
TEST(PolarisedPlanes, AtBrewstersAngleLightIsPolarisedAcrossThePlaneOfIncidence) {
  const double angle = std::atan(1.5) / kRadians;
  const double s = std::pow(1.25 / 3.25, 2) / 2;
  expect_stokes(stokes({{plane_normal(angle, 0), 1.5}}), {s, s, 0, 0});
  expect_stokes(stokes({{plane_normal(angle, 90), 1.5}}), {s, -s, 0, 0});
  // Horizontal and turned counter-clockwise: right and up.
  expect_stokes(stokes({{plane_normal(angle, 45), 1.5}}), {s, 0, s, 0});
}

// Born and Wolf, 1.5.4: at n = 1.51 total reflection at 54 degrees 37 minutes and at 48 degrees 37 minutes
// parts p from s by 45 degrees, so that two make circular light of linear light at 45 degrees (Fresnel's
// rhomb).
TEST(PolarisedPlanes, FresnelsRhombMakesCircularLight) {
  const double inside = 1 / 1.51;
  const double angle = 54 + 37. / 60;
  const auto first = plane_normal(angle, 0);
  const Vec3d forward{0, 0, -1};
  const auto between = forward - first * (2 * dot(forward, first));
  // The second face is parallel to the first, seen from within: the beam goes on as it came.
  const std::vector<registry::PolarisedPlane> rhomb{{first, inside}, {-first, inside}};
  ASSERT_NEAR(dot(between, first), -dot(forward, first), 1e-12);
  auto planes = rhomb;
  const auto brewster = std::atan(1.5) / kRadians;
  planes.push_back({plane_normal(brewster, 45), 1.5});  // S2 alone
  const auto light = stokes(planes);
  EXPECT_NEAR(std::fabs(light[3]) / light[0], 1, 1e-4);
  planes.back() = {plane_normal(brewster, -45), 1.5};
  EXPECT_NEAR(stokes(planes)[3], -light[3], 1e-12) << "the other diagonal turns the other way";
}

// The planes of the scene circular_light, whose middle ray was computed once more in another language.
TEST(PolarisedPlanes, AMetalTurnsLinearLightIntoCircularLightOfTheRightSign) {
  const std::vector<registry::PolarisedPlane> planes{{normalised(Vec3d{3, 5, 2}), 0.27, 2.78},
                                                     {normalised(Vec3d{-5, 2, 4}), 1.52}};
  const auto light = stokes(planes);
  EXPECT_NEAR(light[0], 0.0647, 1e-4);
  EXPECT_NEAR(light[1] / light[0], -0.398, 1e-3);
  EXPECT_NEAR(light[2] / light[0], 0.655, 1e-3);
  EXPECT_NEAR(light[3] / light[0], 0.642, 1e-3);
}

TEST(PolarisedPlanes, TheImageHasTheLayersOfItsParameters) {
  scene::Camera camera;
  camera.position_m = {};
  camera.look_at_m = {0, 0, -1};
  camera.fov_y_deg = 0.5;
  camera.width_px = camera.height_px = 3;
  const registry::PolarisedPlanes formula{{{plane_normal(60, 30), 0.27, 2.78}, {plane_normal(35, 80), 1.5}},
                                          2};
  const auto image = analytic::analytic_image(formula, camera);
  ASSERT_EQ(image.channels, (std::vector<std::string>{"R", "G", "B", "S1.R", "S1.G", "S1.B", "S2.R", "S2.G",
                                                      "S2.B", "S3.R", "S3.G", "S3.B"}));
  const auto middle = analytic::polarised_planes(formula, {{}, {0, 0, -1}}, {1, 0, 0});
  for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(image.at(1, 1, i), middle.at(i / 3), 1e-4) << i;
  EXPECT_GT(std::fabs(image.at(1, 1, 9)), 0.01) << "some of it is circular";
}
