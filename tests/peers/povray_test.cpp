#include "peers/povray_render.h"
#include "peers/scenes.h"

#include <gtest/gtest.h>

/// The exporter on the real POV-Ray: images whose values are known in closed form.
namespace {

using namespace orbs;
using namespace orbs::peers;

adapters::PovraySettings fine_radiosity() {
  adapters::PovraySettings settings;
  settings.radiosity.count = 1600;
  settings.radiosity.error_bound = 0.25;
  return settings;
}

TEST(Povray, EmissionIsShownAsGivenAndNotClamped) {
  auto scene = empty_scene(8, 8, 60);
  add_instance(scene, quad({-9, -9, -2}, {18, 0, 0}, {0, 18, 0}),
               add_material(scene, scene::Emission{{5, 0.25, 1000}, {}}));
  const auto image = render_with_povray(scene, "emission");
  EXPECT_EQ(value(image, 4, 4, 0), 5);
  EXPECT_EQ(value(image, 4, 4, 1), 0.25);
  EXPECT_EQ(value(image, 4, 4, 2), 1000);
}

TEST(Povray, CameraMapsEveryPixelOfANonSquareImage) {
  const auto scene = tilted_camera_before_quad({1, 1, 1});
  const auto image = render_with_povray(scene, "camera");
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 64; ++x)
      ASSERT_EQ(value(image, x, y), is_on_tilted_quad(x, y) ? 1 : 0) << x << " " << y;
}

TEST(Povray, MirrorReflectsByItsReflectanceAlone) {
  const auto image = render_with_povray(lamp_in_mirror({0.75, 0.5, 1}), "mirror");
  EXPECT_EQ(value(image, 7, 4, 0), 1.5);
  EXPECT_EQ(value(image, 7, 4, 1), 1);
  EXPECT_EQ(value(image, 7, 4, 2), 2);
  EXPECT_EQ(value(image, 1, 4, 0), 0);
}

TEST(Povray, GlassIsInvisibleInAUniformEnvironment) {
  const auto image = render_with_povray(glass_ball_in_uniform_light(16), "furnace");
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) ASSERT_NEAR(value(image, x, y), 1, 2e-3) << x << " " << y;
}

TEST(Povray, GlassSlabTransmitsWithAllItsInterreflections) {
  const auto image = render_with_povray(glass_slab(3, 12), "slab");
  EXPECT_NEAR(value(image, 1, 1), kSlabTransmission, 2 * kHalf);
}

// The mean of what arrives anywhere is <L_e> / (1 - <rho>) over the area: 0.5 / 0.75 arrives, and 1/3 is
// seen. Emitting meshes light through radiosity alone.
TEST(Povray, RadiosityFillsAnIntegratingSphere) {
  auto scene = integrating_sphere(16, 64);
  scene.trace_depth = 12;
  const auto image = render_with_povray(scene, "integrating-sphere", fine_radiosity());
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) ASSERT_NEAR(value(image, x, y), 1.0 / 3, 0.01) << x << " " << y;
}

// A closed, convex, diffuse body in a uniform environment: L = rho.
TEST(Povray, EnvironmentLightsThroughRadiosity) {
  auto scene = empty_scene(16, 16, 20);
  scene.trace_depth = 2;
  scene.environment.radiance = {1, 2, 0.5};
  add_instance(scene, scene::make_sphere({.radius_m = 1, .segments = 64}),
               add_material(scene, scene::Lambert{{0.5, 0.5, 0.5}, {}}), translation({0, 0, -4}));
  const auto image = render_with_povray(scene, "environment", fine_radiosity());
  EXPECT_NEAR(value(image, 8, 8, 0), 0.5, 2e-3);
  EXPECT_NEAR(value(image, 3, 12, 1), 1, 4e-3);
  EXPECT_NEAR(value(image, 8, 1, 2), 0.25, 1e-3);
}

}  // namespace
