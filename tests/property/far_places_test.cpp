// The position of a scene in its coordinates must not matter, although floats are coarse far from the origin.
#include "scene/camera_frame.h"
#include "scene/relations/motion.h"
#include "unit/tracer/scenes.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;

// Everything that has a position: copied and instanced meshes, an analytic sphere, lights of each shape. All
// numbers are sums of few powers of two, so that translations are exact in double.
scene::Scene furnished() {
  return scene::load_scene_text("test.json",
                                tests::scene_text("[0, 2.5, 6]", "[0, 0.75, 0]", 24, 6, R"(
    "materials": [{"name": "floor", "type": "lambert", "reflectance": [0.8, 0.6, 0.4]},
                  {"name": "glass", "type": "glass", "ior": 1.5},
                  {"name": "mirror", "type": "mirror", "reflectance": [0.9, 0.9, 0.9]},
                  {"name": "glow", "type": "emission", "radiance": [3, 2, 1]}],
    "meshes": [{"name": "floor", "generator": "plane", "half_size": 6, "material": "floor"},
               {"name": "wall", "generator": "plane", "half_size": 1, "material": "mirror"},
               {"name": "cube", "generator": "cube", "half_size": 0.25, "material": "glass"},
               {"name": "lamp", "generator": "plane", "half_size": 0.25, "material": "glow"}],
    "instances": [{"mesh": "floor"},
                  {"mesh": "wall", "matrix": [{"translate": [-1.5, 1, -1]}, {"rotate_x": 80}]},
                  {"mesh": "cube", "matrix": [{"translate": [0.75, 0.5, 1]}, {"rotate_y": 30}]},
                  {"mesh": "cube", "matrix": [{"translate": [-0.75, 0.5, 1]}]},
                  {"mesh": "lamp", "matrix": [{"translate": [1.5, 1, 0]}, {"rotate_z": 70}]}],
    "shapes": [{"type": "sphere", "centre": [0, 0.5, 0], "radius": 0.5, "material": "glass"}],
    "lights": [{"type": "rect", "half_width": 0.25, "half_length": 0.25, "radiance": [8, 8, 8],
                "matrix": [{"translate": [0.5, 3, 0.25]}]},
               {"type": "disk", "radius": 0.25, "radiance": [8, 4, 8], "matrix": [{"translate": [-2, 3, 0.5]}]},
               {"type": "sphere", "radius": 0.25, "radiance": [2, 4, 8], "matrix": [{"translate": [2, 2, 1]}]}])",
                                                  "40"),
                                ORBS_SOURCE_DIR);
}

void move(Mat4& matrix, Vec3d by) {
  matrix(0, 3) += by.x;
  matrix(1, 3) += by.y;
  matrix(2, 3) += by.z;
}

scene::Scene moved(scene::Scene scene, Vec3d by) {
  scene.camera.position_m += by;
  scene.camera.look_at_m += by;
  for (auto& instance : scene.instances) move(instance.matrix, by);
  for (auto& light : scene.lights) move(light.matrix, by);
  for (auto& sphere : scene.spheres) sphere.centre_m += by;
  return scene;
}

image::Image rendered(const scene::Scene& scene) {
  const std::atomic<bool> never{false};
  // Meshes with several instances are instanced.
  const auto world = tracer::make_world(scene, {.most_copied_triangles = 0});
  return tracer::render(world, {.samples_per_pixel = 16}, never, [](const tracer::Progress&) {}).image;
}

// Bit-identical for translations by whole steps of the tracer's origin.
TEST(FarPlaces, ShowTheSameImage) {
  const auto at_zero = rendered(furnished());
  EXPECT_GT(tests::mean_of_channel(at_zero, 0), 0.05);
  for (const Vec3d by : {Vec3d{1048576, -256, 512}, Vec3d{-268435456, 4096, 67108864}})
    EXPECT_EQ(rendered(moved(furnished(), by)).pixels, at_zero.pixels) << by.x;
}

// Within a step the camera is up to 128 m from the origin, where floats are 8e-6 m apart.
TEST(FarPlaces, ShowNearlyTheSameImageInBetween) {
  const auto at_zero = rendered(furnished());
  const auto between = rendered(moved(furnished(), Vec3d{1048576 + 100, -100, 612}));
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(tests::mean_of_channel(between, c), tests::mean_of_channel(at_zero, c),
                0.01 * tests::mean_of_channel(at_zero, c));
}

// Seen through a telescope 10^5 m away, floats of that distance are 8 mm apart: rays must meet the scene
// better.
TEST(FarPlaces, AreMetByTheRaysOfADistantCamera) {
  auto far = furnished();
  far.camera.position_m = {0, 0.75, 1e5};
  far.camera.fov_y_deg = 0.005;
  const auto world = tracer::make_world(far, {});
  const auto frame = scene::camera_frame(far.camera);
  for (const float pixel : {0.5F, 3.25F, 20.0F}) {
    const auto ray = tracer::camera_ray(world.camera, pixel, pixel);
    const double x = 2 * static_cast<double>(pixel) / world.camera.width - 1;
    const double y = 1 - 2 * static_cast<double>(pixel) / world.camera.height;
    // Both at the depth of the scene's middle, whose coordinates are those of the world.
    const Vec3d direction =
        frame.forward + frame.right * (x * frame.half_width) + frame.up * (y * frame.half_height);
    const Vec3d wanted = far.camera.position_m + direction * 1e5;
    const Vec3d origin = cast<double>(ray.origin);
    const Vec3d along = cast<double>(ray.direction);
    const Vec3d met = origin - along * (origin.z / along.z);
    EXPECT_LT(length(met - wanted), 1e-5) << pixel;
    EXPECT_GT(ray.origin.z, 12) << "it must begin before the scene";
  }
}

// Products of four lengths of 10^10 m are no floats, so the tracer makes a scene of 2^30 m of a larger one.
TEST(FarPlaces, MayBeLarge) {
  const auto at_size = [](double factor) {
    return rendered(scene::moved(furnished(), scaling({factor, factor, factor})));
  };
  const auto large = at_size(0x1p31);
  EXPECT_EQ(large.pixels, at_size(0x1p26).pixels);
  const auto usual = rendered(furnished());
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(tests::mean_of_channel(large, c), tests::mean_of_channel(usual, c),
                0.01 * tests::mean_of_channel(usual, c));
}

}  // namespace
