#include "peers/povray_render.h"
#include "peers/scenes.h"

#include <algorithm>

#include <gtest/gtest.h>

/// The exporter on the real POV-Ray: pictures whose values are known in closed form.
namespace {

using namespace orbs;
using namespace orbs::peers;

double value(const image::Image& image, int x, int y, std::size_t c = 0) {
  return static_cast<double>(image.at(x, y, c));
}

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

TEST(Povray, CameraMapsEveryPixelOfANonSquarePicture) {
  const auto scene = tilted_camera_before_quad({1, 1, 1});
  const auto image = render_with_povray(scene, "camera");
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 64; ++x)
      ASSERT_EQ(value(image, x, y), is_on_tilted_quad(x, y) ? 1 : 0) << x << " " << y;
}

// L = R L_e exactly; the quad is behind the camera and seen in the mirror, left and right exchanged.
TEST(Povray, MirrorReflectsByItsReflectanceAlone) {
  auto scene = empty_scene(9, 9, 60);
  scene.trace_depth = 2;
  add_instance(scene, quad({-9, -9, -2}, {18, 0, 0}, {0, 18, 0}),
               add_material(scene, scene::Mirror{{0.75, 0.5, 1}}));
  add_instance(scene, quad({0.01, -9, 3}, {9, 0, 0}, {0, 18, 0}),
               add_material(scene, scene::Emission{{2, 2, 2}, {}}));
  const auto image = render_with_povray(scene, "mirror");
  EXPECT_EQ(value(image, 7, 4, 0), 1.5);
  EXPECT_EQ(value(image, 7, 4, 1), 1);
  EXPECT_EQ(value(image, 7, 4, 2), 2);
  EXPECT_EQ(value(image, 1, 4, 0), 0);
}

// No absorption: in a uniform environment a glass body cannot be told from nothing, at any angle, once enough
// interreflections are followed.
TEST(Povray, GlassIsInvisibleInAUniformEnvironment) {
  auto scene = empty_scene(16, 16, 40);
  scene.trace_depth = 16;
  scene.environment = {1, 1, 1};
  add_instance(scene, scene::make_sphere({.radius_m = 1, .segments = 64}),
               add_material(scene, scene::Glass{{1, 1, 1}, 1.5}), translation({0, 0, -4}));
  const auto image = render_with_povray(scene, "furnace");
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) ASSERT_NEAR(value(image, x, y), 1, 2e-3) << x << " " << y;
}

// A slab of glass before an emitter, normal incidence: T = (1 - R) / (1 + R), R = ((n - 1) / (n + 1))^2 =
// 0.04.
TEST(Povray, GlassSlabTransmitsWithAllItsInterreflections) {
  auto scene = empty_scene(3, 3, 2);
  scene.trace_depth = 12;
  add_instance(scene, scene::make_cube({1}), add_material(scene, scene::Glass{{1, 1, 1}, 1.5}),
               translation({0, 0, -3}) * scaling({9, 9, 0.25}));
  add_instance(scene, quad({-99, -99, -6}, {198, 0, 0}, {0, 198, 0}),
               add_material(scene, scene::Emission{{1, 1, 1}, {}}));
  const auto image = render_with_povray(scene, "slab");
  EXPECT_NEAR(value(image, 1, 1), 0.96 / 1.04, 2 * kHalf);
}

// Integrating sphere: the mean of what arrives anywhere is <L_e> / (1 - <rho>) over the area. Northern half
// emits 1, southern half reflects 0.5: 0.5 / 0.75 arrives, and 1/3 is seen. Emitting meshes light through
// radiosity alone.
TEST(Povray, RadiosityFillsAnIntegratingSphere) {
  auto scene = empty_scene(16, 16, 60);
  scene.camera.look_at_m = {0, -1, -0.2};
  scene.trace_depth = 12;
  const int lamp = add_material(scene, scene::Emission{{1, 1, 1}, {}});
  const int wall = add_material(scene, scene::Lambert{{0.5, 0.5, 0.5}, {}});
  add_instance(scene, scene::make_sphere({.radius_m = 2, .segments = 64}), wall);
  auto& materials = scene.meshes[0].triangle_materials;
  std::fill(materials.begin(), materials.begin() + static_cast<std::ptrdiff_t>(materials.size() / 2), lamp);
  const auto image = render_with_povray(scene, "integrating-sphere", fine_radiosity());
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) ASSERT_NEAR(value(image, x, y), 1.0 / 3, 0.01) << x << " " << y;
}

// A closed, convex, diffuse body in a uniform environment: L = rho.
TEST(Povray, EnvironmentLightsThroughRadiosity) {
  auto scene = empty_scene(16, 16, 20);
  scene.trace_depth = 2;
  scene.environment = {1, 2, 0.5};
  add_instance(scene, scene::make_sphere({.radius_m = 1, .segments = 64}),
               add_material(scene, scene::Lambert{{0.5, 0.5, 0.5}, {}}), translation({0, 0, -4}));
  const auto image = render_with_povray(scene, "environment", fine_radiosity());
  EXPECT_NEAR(value(image, 8, 8, 0), 0.5, 2e-3);
  EXPECT_NEAR(value(image, 3, 12, 1), 1, 4e-3);
  EXPECT_NEAR(value(image, 8, 1, 2), 0.25, 1e-3);
}

}  // namespace
