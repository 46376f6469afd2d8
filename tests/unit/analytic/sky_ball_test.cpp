#include "analytic/analytic_image.h"
#include "scene/load/load_scene.h"

#include <numbers>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

// The irradiance of a plane under a sky, by the midpoint rule over the hemisphere.
double irradiance(Vec3d normal, double constant, Vec3d gradient) {
  constexpr int kSteps = 400;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < 2 * kSteps; ++j) {
      const double y = -1 + 2 * (i + 0.5) / kSteps;
      const double across = std::sqrt(1 - y * y);
      const double phi = (j + 0.5) * std::numbers::pi / kSteps;
      const Vec3d d{across * std::cos(phi), y, across * std::sin(phi)};
      sum += std::max(0.0, dot(d, normal)) * (constant + dot(gradient, d));
    }
  return sum * (2. / kSteps) * (std::numbers::pi / kSteps);
}

scene::Camera looking(Vec3d from, Vec3d at) {
  scene::Camera camera;
  camera.position_m = from;
  camera.look_at_m = at;
  camera.up = {0.1, 0.2, 1};
  camera.fov_y_deg = 0.1;
  camera.width_px = camera.height_px = 1;
  return camera;
}

}  // namespace

TEST(SkyBall, ShowsTheIrradianceOfItsNormal) {
  const registry::SkyBall ball{
      {0, 0, 0}, 1, 0.5, {1, 1, 2}, {Vec3d{0.5, 0.2, -0.4}, Vec3d{0, 0.8, 0}, Vec3d{}}, false};
  const Vec3d from{3, 4, 12};
  const auto image = analytic::analytic_image(ball, looking(from, {}));
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(image.pixels[c],
                0.5 / std::numbers::pi * irradiance(normalised(from), ball.constant[c], ball.gradients[c]),
                1e-4)
        << c;
}

TEST(SkyBall, ShowsTheSkyBesideItOrNot) {
  registry::SkyBall ball{{0, 0, 0}, 1, 0.5, {1, 1, 2}, {Vec3d{0.5, 0, 0}, Vec3d{0, 0.8, 0}, Vec3d{0, 0, 1}},
                         true};
  const auto camera = looking({0, 0, 5}, {0, 5, 5});
  const auto seen = analytic::analytic_image(ball, camera);
  EXPECT_NEAR(seen.pixels[0], 1, 1e-5);
  EXPECT_NEAR(seen.pixels[1], 1.8, 1e-5);
  ball.shows_sky = false;
  EXPECT_EQ(analytic::analytic_image(ball, camera).pixels[1], 0);
}
