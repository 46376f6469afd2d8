// Light where rounding could decide: from lights that reflect, from small lights, and onto surfaces close to
// them.
#include "property/light_images.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::tests;

std::string white(const std::string& mesh, const std::string& light) {
  return R"("materials": [{"name": "white", "type": "lambert", "reflectance": [1, 1, 1]}], )" +
         meshes({mesh}) + R"(, "lights": [)" + light + "]";
}

// Renders a white square `depth_m` below the origin of the world, lit by the light; the camera looks at its
// middle.
image::Image floor_lit_by(const std::string& light, double depth_m) {
  const View view{.position = text_of({0.3, 0.5 - depth_m, 0.2}), .look_at = text_of({0, -depth_m, 0})};
  const Vec3d middle{0, -depth_m, 0};
  return image_of(scene_of(view, white(square(middle, {0, 1, 0}, 1, "white"), light), "1"), 64);
}

void expect_red(const image::Image& image, double expected, double relative) {
  EXPECT_NEAR(mean_of_channel(image, 0) / expected, 1, relative + 4 * error_of_mean(image, 0) / expected);
}

}  // namespace

// A light is flat or convex, so it does not illuminate itself: alone in the dark it has nothing to reflect.
TEST(LightRounding, AReflectingLightHasItsStatedRadianceAndNoMore) {
  for (const char* shape : {R"("rect", "half_width": 1, "half_length": 1)", R"("disk", "radius": 1)",
                            R"("sphere", "radius": 1)"}) {
    const auto text =
        scene_of({.position = "[0, -4, 0]", .up = "[0, 0, 1]", .fov_deg = 10},
                 fmt::format(R"("materials": [], "lights": [{{"type": {}, "radiance": [2, 2, 2], )"
                             R"("reflectance": [1, 1, 1], )"
                             R"("matrix": [{{"rotate_x": 20}}, {{"rotate_z": 13}}]}}])",
                             shape),
                 "3");
    const auto image = image_of(text, 32);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) EXPECT_EQ(image.at(x, y, 0), 2) << shape;
  }
}

// The coordinates of a small light at the origin say nothing about the rounding of a long shadow ray. On the
// axis E = L A / d^2, with a relative error of (s / d)^2 < 1e-3 for a square of side s.
TEST(LightRounding, ASmallLightDoesNotShadowItself) {
  for (const auto& [half_side, depth_m] :
       std::map<double, double>{{0.05, 3}, {0.02, 1}, {0.1, 30}, {0.01, 300}})
    for (const char* rotated : {"0", "20"}) {
      const auto light =
          fmt::format(R"({{"type": "rect", "half_width": {0}, "half_length": {0}, "radiance": [1, 1, 1], )"
                      R"("matrix": [{{"rotate_x": {1}}}, {{"rotate_z": {1}}}]}})",
                      half_side, rotated);
      const double cosine = std::pow(std::cos(std::stod(rotated) * std::numbers::pi / 180), 2);
      expect_red(floor_lit_by(light, depth_m),
                 cosine * 4 * half_side * half_side / (std::numbers::pi * depth_m * depth_m), 2e-3);
    }
  for (const auto& [radius, depth_m] : std::map<double, double>{{0.02, 10}, {1, 1000}, {0.1, 3000}}) {
    const auto light = fmt::format(R"({{"type": "sphere", "radius": {}, "radiance": [1, 1, 1]}})", radius);
    expect_red(floor_lit_by(light, depth_m), radius * radius / (depth_m * depth_m), 1e-4);
  }
  const auto disk = R"({"type": "disk", "radius": 0.02, "radiance": [1, 1, 1]})";
  expect_red(floor_lit_by(disk, 10), 4e-6, 1e-4);
}

// E = pi L (R / d)^2 at any distance from the sphere.
TEST(LightRounding, AFloorThatNearlyTouchesABallIsLitByAllOfIt) {
  constexpr double kDepth_m = 1.0001;
  const View view{.position = "[0.02, -1.00005, 0]", .look_at = text_of({0, -kDepth_m, 0})};
  const auto light = R"({"type": "sphere", "radius": 1, "radiance": [1, 1, 1]})";
  const auto text = scene_of(view, white(square({0, -kDepth_m, 0}, {0, 1, 0}, 0.01, "white"), light), "1");
  expect_red(image_of(text, 256), 1 / (kDepth_m * kDepth_m), 1e-3);
}
