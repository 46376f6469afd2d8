// What trial images may cost.
#include "tracer/trial_image.h"

#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr double kShare = 0.07;
constexpr int kImages = 6;

tracer::Camera camera_of(int width, int height) {
  tracer::Camera camera{};
  camera.width = width;
  camera.height = height;
  return camera;
}

}  // namespace

// Sides are rounded to whole pixels, which adds up to a tenth to ten of them.
TEST(TrialSize, StaysWithinItsShareOfThePaths) {
  for (const int width : {17, 64, 128, 512, 1920})
    for (const int samples : {1, 4, 16, 64, 1024}) {
      const auto camera = camera_of(width, width / 2);
      const auto size = tracer::trial_size(camera, {.samples_per_pixel = samples}, kShare, kImages);
      if (!size) continue;
      const double all = 1.0 * kImages * size->width * size->height * size->samples_per_pixel;
      EXPECT_LT(all, 1.15 * kShare * camera.width * camera.height * samples) << width << ' ' << samples;
      EXPECT_LE(size->samples_per_pixel, samples);
      EXPECT_GE(size->width * size->height, 80) << width << ' ' << samples;
    }
}

TEST(TrialSize, IsNoneWhereTooLittleIsLeftToDecideBy) {
  EXPECT_FALSE(tracer::trial_size(camera_of(24, 24), {.samples_per_pixel = 16}, kShare, kImages));
  EXPECT_FALSE(tracer::trial_size(camera_of(8, 8), {.samples_per_pixel = 4}, kShare, kImages));
  EXPECT_TRUE(tracer::trial_size(camera_of(64, 64), {.samples_per_pixel = 64}, kShare, kImages));
}

// Two techniques with the same noise, of which the second misses the light of a quarter of the pixels.
TEST(RelativeErrors, CountLightThatOnlyOneTechniqueFinds) {
  tracer::Trial first;
  tracer::Trial second;
  for (std::size_t seed = 0; seed < 2; ++seed) {
    first.images[seed] = image::make_image(8, 8, {"R", "G", "B"});
    second.images[seed] = first.images[seed];
    for (std::size_t i = 0; i < first.images[seed].pixels.size(); ++i) {
      const float noise = (i + seed) % 2 == 0 ? 0.9F : 1.1F;
      first.images[seed].pixels[i] = noise;
      second.images[seed].pixels[i] = i / 3 % 4 == 0 ? 0 : noise;
    }
  }
  const auto same = tracer::relative_errors(first, first);
  EXPECT_NEAR(same.first, 0.02, 0.001);
  EXPECT_EQ(same.first, same.second);
  const auto errors = tracer::relative_errors(first, second);
  EXPECT_LT(errors.first, 0.05);
  EXPECT_GT(errors.second, 0.2);
}
