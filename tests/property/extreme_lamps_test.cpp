// Closed forms for lamps that are very near, very large or very small, cameras on surfaces, and paths that
// nothing ends.
#include "tracer/render/variance.h"
#include "unit/tracer/scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;

constexpr const char* kWhiteFloor =
    R"("materials": [{"name": "w", "type": "lambert", "reflectance": [1, 1, 1]}],
    "meshes": [{"name": "f", "generator": "plane", "half_size": 0.25, "material": "w"}],
    "instances": [{"mesh": "f", "matrix": [{"rotate_y": 17}]}], "lights": [)";

// Mean and standard error of the floor's radiance, from 64 pixels.
void expect_radiance(const std::string& eye, const std::string& lamp, double expected) {
  const auto image =
      tests::render_text(tests::scene_text(eye, "[0, 0, 0]", 8, 1, kWhiteFloor + lamp + "]", "0.02"),
                         {.samples_per_pixel = 256})
          .image;
  EXPECT_NEAR(tests::mean_of_channel(image, 0), expected,
              4 * tests::error_of_mean(image, 0) + 1e-3 * expected)
      << lamp;
}

}  // namespace

// A floor under a lamp that covers the sky has the lamp's radiance. The ends of shadow rays were pushed off
// the lamp by more than its height: 0.598.
TEST(ExtremeLamps, JustAboveTheFloorAndOfAThousandKilometresCoverTheSky) {
  expect_radiance("[3e-7, 5e-7, 1e-7]", R"({"type": "rect", "half_width": 1, "half_length": 1,
    "radiance": [1, 1, 1], "matrix": [{"translate": [0, 1e-6, 0]}]})",
                  1);
  expect_radiance("[0.05, 0.2, -0.02]", R"({"type": "rect", "half_width": 1e6, "half_length": 1e6,
    "radiance": [1, 1, 1], "matrix": [{"translate": [0, 1, 0]}]})",
                  1);
}

// A small sphere far away: L r^2 cos / d^2, with d^2 = 0.3^2 + 1.1^2 + 0.2^2 and cos = 1.1 / d. Its side was
// decided by the difference of two places that floats hardly tell apart: 0.650 at 1e-7 m, black at 1e-9 m.
TEST(ExtremeLamps, SmallSpheresShineInFull) {
  const double d = std::sqrt(0.3 * 0.3 + 1.1 * 1.1 + 0.2 * 0.2);
  for (const double r : {1e-4, 1e-6, 1e-7, 1e-9})
    expect_radiance("[0.05, 0.2, -0.02]",
                    fmt::format(R"({{"type": "sphere", "radius": {0}, "radiance": [{1}, {1}, {1}],
                      "matrix": [{{"translate": [0.3, 1.1, 0.2]}}]}})",
                                r, 1 / (r * r)),
                    1.1 / (d * d * d));
}

// The square of 1e25 is no float, and the infinite variances made every image certain to be right.
TEST(ExtremeRadiances, HaveNoVariancesThatFloatsCannotHold) {
  const auto floor_under = [](const std::string& radiance) {
    const std::string lamp = fmt::format(
        R"({{"type": "rect", "half_width": 1, "half_length": 1, "radiance": [{0}, {0}, {0}],
        "matrix": [{{"translate": [0.5, 1, 0]}}]}}])",
        radiance);
    return tests::render_text(
        tests::scene_text("[0.05, 0.2, -0.02]", "[0, 0, 0]", 4, 4, kWhiteFloor + lamp, "0.1"),
        {.samples_per_pixel = 16});
  };
  for (const char* radiance : {"1e25", "1e-25"}) {
    const auto made = floor_under(radiance);
    EXPECT_TRUE(made.variance_leaves_floats) << radiance;
    EXPECT_EQ(image::channel_index(made.image, "variance.R"), -1) << radiance;
    EXPECT_GT(tests::mean_of_channel(made.image, 0), 0) << radiance;
  }
  for (const char* radiance : {"1e12", "1", "1e-10"}) {
    const auto made = floor_under(radiance);
    EXPECT_FALSE(made.variance_leaves_floats) << radiance;
    EXPECT_GE(image::channel_index(made.image, "variance.R"), 0) << radiance;
  }
}

// Beside a bright pixel the variance of a dim one may be smaller than any float, and 0 would say that its
// value is certain.
TEST(ExtremeRadiances, DoNotHideThatDimPixelsHaveNoise) {
  auto film = tracer::make_film(3, 1);
  const std::vector<Vec3d> variances{{1, 1, 1}, {1e-50, 1e-50, 1e-50}, {}};
  tracer::add_sample(film.pixels[0], {2, 2, 2});
  tracer::add_sample(film.pixels[1], {1e-25, 1e-25, 1e-25});
  tracer::add_sample(film.pixels[2], {1e-25, 1e-25, 1e-25});
  for (std::size_t i = 0; i < 3; ++i) tracer::end_piece(film, i, 0);
  ASSERT_TRUE(tracer::float_holds_variances(film, variances));
  const auto image = tracer::resolve(film, variances);
  EXPECT_EQ(image.at(0, 0, 3), 1);
  EXPECT_EQ(image.at(1, 0, 3), std::numeric_limits<float>::denorm_min());
  EXPECT_EQ(image.at(2, 0, 3), 0);
}

// A camera that lies on a floor and looks away from it sees the sky. The floor was hit at distance zero.
TEST(ExtremeCameras, OnAFloorSeeTheSky) {
  const auto image = tests::render_text(tests::scene_text("[0, 0, 0]", "[0, 1, 0]", 4, 1,
                                                          R"("environment": [1, 1, 1],
    "materials": [{"name": "w", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}],
    "meshes": [{"name": "f", "generator": "plane", "half_size": 1, "material": "w"}],
    "instances": [{"mesh": "f"}])",
                                                          "60"),
                                        {.samples_per_pixel = 4})
                         .image;
  EXPECT_EQ(tests::mean_of_channel(image, 0), 1);
}

// A floor is seen by way of some 2000 reflections in two mirrors. When nearly all paths ended behind the
// thousandth, the known case planes-between-mirrors was too dark by its limit, 0.1 %.
TEST(EndlessPaths, BetweenTwoMirrorsShowTheirHorizon) {
  constexpr int kSide = 64;
  constexpr int kSamples = 1;
  const auto image = tests::render_text(R"({"format": "orbs-scene/1", "name": "hall",
    "camera": {"position": [0, 0.5, 0.25], "look_at": [0, 0.49975, -0.75], "fov_y": 0.004, "width": 64, "height": 64},
    "materials": [{"name": "m", "type": "mirror", "reflectance": [1, 1, 1]},
                  {"name": "f", "type": "emission", "radiance": [1, 1, 1]}],
    "meshes": [{"name": "a", "generator": "plane", "half_size": 1, "material": "m"},
               {"name": "b", "generator": "plane", "half_size": 1, "material": "f"}],
    "instances": [{"mesh": "a", "matrix": [{"translate": [0, 0, -0.5]}, {"rotate_x": 90}]},
                  {"mesh": "a", "matrix": [{"translate": [0, 0, 0.5]}, {"rotate_x": -90}]},
                  {"mesh": "b"}],
    "integrator": {"trace_depth": "unlimited"}})",
                                        {.samples_per_pixel = kSamples})
                         .image;
  // Half of the paths come so far and count twice.
  const double error = 1 / std::sqrt(kSide * kSide * kSamples);
  EXPECT_NEAR(tests::mean_of_channel(image, 0), 1, 5 * error);
}

// Between lossless mirrors no path loses throughput, and without a limit none would ever end.
TEST(EndlessPaths, InAClosedMirrorRoomEnd) {
  const auto image = tests::render_text(R"({"format": "orbs-scene/1", "name": "room",
    "camera": {"position": [0.1, 0.2, 0.3], "look_at": [1, 0.4, 0.2], "width": 4, "height": 4},
    "materials": [{"name": "m", "type": "mirror", "reflectance": [1, 1, 1]}],
    "meshes": [{"name": "room", "generator": "cube", "half_size": 1, "material": "m"}],
    "instances": [{"mesh": "room"}], "environment": [1, 1, 1],
    "integrator": {"trace_depth": "unlimited"}})",
                                        {.samples_per_pixel = 1})
                         .image;
  EXPECT_LT(tests::mean_of_channel(image, 0), 0.01);
}
