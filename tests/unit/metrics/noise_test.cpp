#include "metrics/noise_test.h"

#include "base/error.h"
#include "base/random.h"
#include "metrics/describe.h"
#include "metrics/seeds.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace {

using namespace orbs::metrics;
using orbs::mix;
using orbs::unit_random;
using orbs::image::Image;

constexpr std::uint64_t kReferenceSeed = 1'000'000;

/// One sample of a pixel's light, from a random key.
using Light = std::function<double(std::uint64_t key, int pixel)>;

double from_half_to_three_halves(std::uint64_t key, int /*pixel*/) { return 0.5 + unit_random(mix(key, 1)); }

double penumbra(std::uint64_t key, int /*pixel*/) { return unit_random(mix(key, 1)) < 0.1 ? 1.0 : 0.0; }

// One sample in 1000 carries a third of the light.
double fireflies(std::uint64_t key, int /*pixel*/) {
  return 0.8 * unit_random(mix(key, 1)) + (unit_random(mix(key, 2)) < 1e-3 ? 200.0 : 0.0);
}

struct Render {
  int size_px = 32;
  int spp = 16;
  std::uint64_t seed = 1;
};

// A grey image as the tracer makes it: mean and variance of the mean from four independent pieces, which is
// as rough as suite images get.
Image rendered(const Light& light, const Render& render) {
  constexpr int kPieces = 4;
  Image image = orbs::image::make_image(render.size_px, render.size_px,
                                        {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  image.attributes = {{"orbs.program", "test"}, {"orbs.spp", std::to_string(render.spp)}};
  const int length = render.spp / kPieces;
  for (int pixel = 0; pixel < render.size_px * render.size_px; ++pixel) {
    double sum = 0;
    double squares = 0;
    for (int piece = 0; piece < kPieces; ++piece) {
      double mean = 0;
      for (int i = 0; i < length; ++i)
        mean += light(mix(mix(render.seed, static_cast<std::uint64_t>(pixel)),
                          static_cast<std::uint64_t>(piece * length + i)),
                      pixel) /
                length;
      sum += mean;
      squares += mean * mean;
    }
    const double mean = sum / kPieces;
    // Rounding only: the exact scatter is not negative.
    const double scatter = std::max(0.0, squares / kPieces - mean * mean);
    for (int c = 0; c < 3; ++c) {
      float* const at = &image.pixels[static_cast<std::size_t>(6 * pixel + c)];
      at[0] = static_cast<float>(mean);
      at[3] = static_cast<float>(scatter / (kPieces - 1));
    }
  }
  return image;
}

Image brighter(Image image, float factor) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] *= i % 6 < 3 ? factor : factor * factor;
  return image;
}

bool is_biased(const NoiseTest& test) { return !bias_message(test).empty(); }

Image without_variance(const Image& image) { return orbs::image::select_rgb(image, ""); }

int false_alarms(const Light& light, int images, bool exact_reference = false) {
  Image reference = rendered(light, {.size_px = 24, .spp = 256, .seed = kReferenceSeed});
  if (exact_reference) {
    reference = without_variance(reference);
    for (float& value : reference.pixels) value = 1.0F;
  }
  int alarms = 0;
  for (int i = 1; i <= images; ++i) {
    const Image result = rendered(light, {.size_px = 24, .seed = static_cast<std::uint64_t>(i)});
    alarms += is_biased(test_noise(result, reference)) ? 1 : 0;
  }
  return alarms;
}

}  // namespace

// 1 in 1000 is promised. 300 images then have more than 3 with probability 3e-4; the seeds are fixed.
TEST(NoiseTest, UnbiasedSeedsAreNotCalledBiased) {
  EXPECT_LE(false_alarms(from_half_to_three_halves, 300), 3);
  EXPECT_LE(false_alarms(penumbra, 300), 3);
  EXPECT_LE(false_alarms(from_half_to_three_halves, 300, /*exact_reference=*/true), 3);
}

// Most results have seen too few fireflies, and their own variance with them; the reference knows better.
TEST(NoiseTest, UnbiasedSeedsWithFirefliesAreNotCalledBiased) { EXPECT_LE(false_alarms(fireflies, 300), 3); }

// Standard deviation of one pixel: 1/sqrt(12) / sqrt(16) = 7 % of the mean. The mean of 64^2 of them has 0.11
// %, so 1 % is nine of its standard deviations, and t for 1 in 21000 is four.
TEST(NoiseTest, OnePercentMoreEnergyIsSeenInAnImageWithSevenPercentNoise) {
  const Image reference =
      rendered(from_half_to_three_halves, {.size_px = 64, .spp = 64, .seed = kReferenceSeed});
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Image honest = rendered(from_half_to_three_halves, {.size_px = 64, .seed = seed});
    EXPECT_FALSE(mean_error(test_noise(honest, reference))) << seed;
    for (const float factor : {1.01F, 0.99F}) {
      const auto error = mean_error(test_noise(brighter(honest, factor), reference));
      ASSERT_TRUE(error) << seed;
      EXPECT_NEAR(error->value, static_cast<double>(factor) - 1, 0.006);
      EXPECT_LT(error->low, error->value);
    }
  }
}

// The error of the ratio by its formula: sqrt(sum of variances) / sum, here with exact numbers: 0.04^2 in
// each of 1024 pixels of 0.5 makes 0.04 / 0.5 / 32 = 0.0025; Student's t with 1024 degrees of freedom for
// 1/21000 is 4.083.
TEST(NoiseTest, TheIntervalOfTheMeanRatioIsThatOfTheDeltaMethod) {
  Image result = orbs::image::make_image(32, 32, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (std::size_t i = 0; i < result.pixels.size(); ++i) result.pixels[i] = i % 6 < 3 ? 0.5F : 0.0016F;
  Image reference = without_variance(result);
  const auto test = test_noise(brighter(result, 1.0F), reference);
  EXPECT_NEAR(test.mean_ratio[0]->value, 0.0, 1e-12);
  EXPECT_NEAR(test.mean_ratio[0]->high, 4.083 * 0.0025, 2e-5);
  EXPECT_NEAR(test.noise_squared, 0.0016, 1e-9);
  EXPECT_NEAR(test.bias_squared.value, -0.0016, 1e-9);
  // A reference with the same noise: sqrt(2) of it.
  EXPECT_NEAR(test_noise(result, result).mean_ratio[0]->high, 4.083 * 0.0025 * std::sqrt(2), 4e-5);
}

// One pixel that carries the variance: no more than one degree of freedom, and a t beyond a thousand.
TEST(NoiseTest, AFireflyThatRulesTheVarianceMakesTheIntervalWide) {
  Image result = rendered(from_half_to_three_halves, {});
  const Image reference = rendered(from_half_to_three_halves, {.spp = 64, .seed = kReferenceSeed});
  const double before = test_noise(result, reference).mean_ratio[1]->high;
  result.at(7, 9, 1) = 500;
  result.at(7, 9, 4) = 500 * 500;
  const auto ratio = test_noise(result, reference).mean_ratio[1].value();
  EXPECT_LT(ratio.low, 0);
  EXPECT_GT(ratio.high, 1000 * before);
}

TEST(NoiseTest, BiasAndNoiseAreTwoNumbers) {
  const Image reference =
      rendered(from_half_to_three_halves, {.size_px = 64, .spp = 256, .seed = kReferenceSeed});
  Image result = rendered(from_half_to_three_halves, {.size_px = 64});
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    if (i % 6 < 3) result.pixels[i] += 0.05F;
  const auto test = test_noise(result, reference);
  // 1/12 / 16 of the result and 1/12 / 256 of the reference; 0.05^2. Standard error of a mean of 4096 squares
  // of deviation sqrt(2) * 0.0055 and of four times the product with the bias: 2e-4.
  EXPECT_NEAR(test.noise_squared, 1.0 / 192 + 1.0 / 3072, 3e-4);
  EXPECT_NEAR(test.bias_squared.value, 0.0025, 8e-4);
  EXPECT_GT(test.bias_squared.low, 0);
  EXPECT_TRUE(is_square_biased(test));
}

// A block of 8 x 8 that is 15 % too bright is 1/64 of the image: the mean moves by 0.2 %, the block by 17
// of its standard deviations.
TEST(NoiseTest, ALocalErrorIsSeenByItsBlock) {
  const Image reference =
      rendered(from_half_to_three_halves, {.size_px = 64, .spp = 64, .seed = kReferenceSeed});
  Image result = rendered(from_half_to_three_halves, {.size_px = 64});
  EXPECT_EQ(test_noise(result, reference).blocks.off, 0);
  for (int y = 24; y < 32; ++y)
    for (int x = 40; x < 48; ++x)
      for (std::size_t c = 0; c < 3; ++c) result.at(x, y, c) += 0.15F;
  const auto test = test_noise(result, reference);
  EXPECT_FALSE(mean_error(test));
  EXPECT_EQ(test.blocks.tested, 3 * (64 + 16 + 4 + 1));  // of 8, 16, 32 and 64 px
  EXPECT_EQ(test.blocks.scales[0].off, 3);
  EXPECT_EQ(test.blocks.where.x0, 40);
  EXPECT_EQ(test.blocks.where.y0, 24);
  EXPECT_EQ(test.blocks.where.x1, 48);
  EXPECT_EQ(test.blocks.where.y1, 32);
  EXPECT_NE(bias_message(test).find("over 8 x 8 px in [40,24,48,32], by +"), std::string::npos)
      << bias_message(test);
  EXPECT_FALSE(is_biased(test_noise(result, reference, {{{40, 24, 48, 32}}, {}})));
}

TEST(NoiseTest, PixelScoresPointAtTheWorstPixel) {
  const Image reference = rendered(from_half_to_three_halves, {.spp = 64, .seed = kReferenceSeed});
  Image result = rendered(from_half_to_three_halves, {});
  EXPECT_LT(test_noise(result, reference).pixels->share_beyond_3, 0.01);
  result.at(3, 21, 2) += 5;
  const auto pixels = test_noise(result, reference).pixels.value();
  EXPECT_GT(pixels.largest, 20);
  EXPECT_EQ(pixels.where.x0, 3);
  EXPECT_EQ(pixels.where.y0, 21);
}

// Rounding is no bias, however little noise there is.
TEST(NoiseTest, WithoutNoiseOnlyWhatIsNotNegligibleIsABias) {
  Image result = orbs::image::make_image(32, 32, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (std::size_t i = 0; i < result.pixels.size(); ++i) result.pixels[i] = i % 6 < 3 ? 0.5F : 0.0F;
  EXPECT_FALSE(is_biased(test_noise(brighter(result, 1.0005F), result)));
  EXPECT_TRUE(is_biased(test_noise(brighter(result, 1.002F), result)));
  EXPECT_FALSE(is_biased(test_noise(without_variance(brighter(result, 1.0005F)), result)));
  EXPECT_TRUE(is_biased(test_noise(without_variance(brighter(result, 1.002F)), result)));
}

TEST(NoiseTest, ABlackChannelHasNoRatio) {
  Image result = rendered(from_half_to_three_halves, {});
  for (std::size_t i = 2; i < result.pixels.size(); i += 3) result.pixels[i] = 0;
  const auto test = test_noise(result, result);
  EXPECT_TRUE(test.mean_ratio[0]);
  EXPECT_FALSE(test.mean_ratio[2]);
  EXPECT_FALSE(is_biased(test));
}

// An error with structure in it scatters as noise does, and a mean that is right cannot be told then. Of a
// renderer without noise the mean is what it is.
TEST(NoiseTest, TheMeanOfAnImageWithoutNoiseIsExact) {
  const Image reference = without_variance(
      rendered(from_half_to_three_halves, {.size_px = 64, .spp = 256, .seed = kReferenceSeed}));
  Image result = reference;
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    result.pixels[i] += (i / 3 / 8 + i / 3 / 512) % 2 == 0 ? 0.25F : -0.25F;  // a chessboard of blocks
  const auto known = test_noise(result, reference, {}, ResultNoise::NoiseFree);
  EXPECT_EQ(known.source, NoiseSource::Reference);
  EXPECT_NEAR(known.mean_ratio[0]->value, 0, 1e-6);
  EXPECT_EQ(known.mean_ratio[0]->low, known.mean_ratio[0]->high);
  EXPECT_NEAR(known.bias_squared.value, 0.0625, 1e-6);
  EXPECT_EQ(known.noise_squared, 0);
  EXPECT_TRUE(is_biased(known));
  EXPECT_GT(test_noise(result, reference).mean_ratio[0]->high, 0.007);
}

// The image of a renderer that writes no variance: its noise is read off the image.
TEST(NoiseTest, WithoutVarianceTheScatterOfBlocksBoundsTheMean) {
  const Image reference =
      rendered(from_half_to_three_halves, {.size_px = 64, .spp = 256, .seed = kReferenceSeed});
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Image result = without_variance(rendered(from_half_to_three_halves, {.size_px = 64, .seed = seed}));
    const auto test = test_noise(result, reference);
    EXPECT_EQ(test.source, NoiseSource::Scatter);
    EXPECT_EQ(test.blocks.off, 0) << seed;
    EXPECT_FALSE(is_biased(test)) << seed;
    EXPECT_NEAR(test.noise_squared, 1.0 / 192 + 1.0 / 3072, 6e-4);
    Image bright = result;
    for (float& value : bright.pixels) value *= 1.02F;
    EXPECT_TRUE(mean_error(test_noise(bright, reference))) << seed;
  }
}

// 2 % of 64 x 64 px is twelve of the block's standard deviations and no more than 0.7 of a pixel's.
TEST(NoiseTest, ASmallErrorIsSeenByALargeBlock) {
  const Image reference =
      rendered(from_half_to_three_halves, {.size_px = 128, .spp = 256, .seed = kReferenceSeed});
  for (const bool knows_noise : {true, false}) {
    Image result = rendered(from_half_to_three_halves, {.size_px = 128});
    if (!knows_noise) result = without_variance(result);
    EXPECT_EQ(test_noise(result, reference).blocks.off, 0);
    for (int y = 64; y < 128; ++y)
      for (int x = 0; x < 64; ++x)
        for (std::size_t c = 0; c < 3; ++c) result.at(x, y, c) *= 1.02F;
    const auto test = test_noise(result, reference);
    EXPECT_EQ(test.blocks.scales[3].off, 3);
    EXPECT_EQ(test.blocks.scales[0].off, 0);
  }
}

// What the smallest error of a block is said to be is found in most blocks, and half of it in few.
TEST(NoiseTest, TheSmallestErrorOfABlockIsFound) {
  const Image reference =
      rendered(from_half_to_three_halves, {.size_px = 128, .spp = 256, .seed = kReferenceSeed});
  const Image honest = rendered(from_half_to_three_halves, {.size_px = 128});
  const double smallest = *test_noise(honest, reference).blocks.scales[1].smallest_error;
  const auto blocks_off = [&](double error) {
    Image result = honest;
    for (std::size_t i = 0; i < result.pixels.size(); ++i)
      if (i % 6 < 3) result.pixels[i] *= static_cast<float>(1 + error);
    return test_noise(result, reference).blocks.scales[1].off;
  };
  constexpr int kTests = 3 * 64;
  EXPECT_GT(blocks_off(1.3 * smallest), kTests / 2);
  EXPECT_LT(blocks_off(0.5 * smallest), kTests / 4);
  EXPECT_EQ(hidden_by_noise(test_noise(honest, reference)).empty(), smallest <= 0.05) << smallest;
}

// An image without noise has that of the reference alone to hide its errors.
TEST(NoiseTest, TheBlocksOfAnImageWithoutNoiseAreTested) {
  const Image reference =
      rendered(from_half_to_three_halves, {.size_px = 64, .spp = 256, .seed = kReferenceSeed});
  Image result = without_variance(reference);
  for (float& value : result.pixels) value = 1.0F;
  EXPECT_FALSE(is_biased(test_noise(result, reference, {}, ResultNoise::NoiseFree)));
  for (int y = 8; y < 16; ++y)
    for (int x = 8; x < 16; ++x)
      for (std::size_t c = 0; c < 3; ++c) result.at(x, y, c) = 1.05F;
  EXPECT_GE(test_noise(result, reference, {}, ResultNoise::NoiseFree).blocks.scales[0].off, 3);
}

// Stripes of 5 % change no mean and no block, but the squares where the reference is smooth.
TEST(NoiseTest, AnErrorOfMeanZeroIsSeenAwayFromEdges) {
  const Image reference =
      rendered(from_half_to_three_halves, {.size_px = 64, .spp = 256, .seed = kReferenceSeed});
  Image result = rendered(from_half_to_three_halves, {.size_px = 64, .spp = 64});
  EXPECT_FALSE(is_residual(test_noise(result, reference)));
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (std::size_t c = 0; c < 3; ++c) result.at(x, y, c) *= (x / 2 + y / 2) % 2 == 0 ? 1.05F : 0.95F;
  const auto test = test_noise(result, reference);
  EXPECT_EQ(test.blocks.off, 0);
  EXPECT_TRUE(is_residual(test));
}

// A filter that is wider than a pixel gives neighbours a common noise.
TEST(NoiseTest, CorrelatedNoiseIsSeen) {
  const Image reference =
      rendered(from_half_to_three_halves, {.size_px = 64, .spp = 256, .seed = kReferenceSeed});
  const Image honest = without_variance(rendered(from_half_to_three_halves, {.size_px = 64}));
  EXPECT_FALSE(test_noise(honest, reference).correlation);
  Image filtered = honest;
  for (int y = 0; y < 64; ++y)
    for (int x = 1; x < 64; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        filtered.at(x, y, c) = (honest.at(x - 1, y, c) + honest.at(x, y, c)) / 2;
  const auto correlation = test_noise(filtered, reference).correlation;
  ASSERT_TRUE(correlation);
  EXPECT_EQ(correlation->dx, 1);
  EXPECT_EQ(correlation->dy, 0);
  EXPECT_NEAR(correlation->value, 0.5, 0.1);  // that of the mean of two: 1/4 + 1/4 shared of 1/2
}

// Floats round alike in all pixels of an even surface.
TEST(NoiseTest, RoundingIsNoCorrelatedNoise) {
  Image reference = rendered(from_half_to_three_halves, {.size_px = 64});
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) reference.pixels[i] = i % 6 < 3 ? 0.5F : 0.0F;
  const auto is_seen = [&](float share) {
    Image result = without_variance(reference);
    for (float& value : result.pixels) value *= 1 + share;
    return test_noise(result, reference).correlation.has_value();
  };
  EXPECT_FALSE(is_seen(1e-6F));
  EXPECT_TRUE(is_seen(1e-4F));
}

// The variance of the image must be there: neither may the image share the reference's samples, nor may it
// state more than it has.
TEST(NoiseTest, TheStatedNoiseMustBeThere) {
  const Image reference =
      rendered(from_half_to_three_halves, {.size_px = 64, .spp = 256, .seed = kReferenceSeed});
  const Image honest = rendered(from_half_to_three_halves, {.size_px = 64});
  EXPECT_EQ(test_noise(honest, reference).stated, StatedNoise::Plausible);
  EXPECT_EQ(test_noise(without_variance(honest), reference).stated, StatedNoise::Plausible);
  EXPECT_EQ(test_noise(reference, reference).stated, StatedNoise::NearerThanReference);
  EXPECT_EQ(test_noise(without_variance(reference), reference).stated, StatedNoise::NearerThanReference);
  EXPECT_EQ(test_noise(without_variance(reference), reference, {}, ResultNoise::NoiseFree).stated,
            StatedNoise::NearerThanReference);
  Image overstated = honest;
  for (std::size_t i = 0; i < overstated.pixels.size(); ++i)
    if (i % 6 >= 3) overstated.pixels[i] *= 16;  // the variance of one sample of 16
  EXPECT_EQ(test_noise(overstated, reference).stated, StatedNoise::OverstatedByResult);
}

// Mean of the light: 1.
TEST(NoiseTest, NoiseOfTheReferenceIsFoundInTheResult) {
  const Image reference =
      rendered(from_half_to_three_halves, {.size_px = 128, .spp = 256, .seed = kReferenceSeed});
  const Image own = rendered(from_half_to_three_halves, {.size_px = 128, .spp = 64});
  const auto made_of =
      [&](const std::function<float(std::size_t pixel, float own, float reference)>& mix_of) {
        Image made = without_variance(own);
        for (std::size_t i = 0; i < made.pixels.size(); ++i)
          made.pixels[i] = mix_of(i / 3, own.pixels[i / 3 * 6 + i % 3], reference.pixels[i / 3 * 6 + i % 3]);
        return made;
      };
  const Image blend = made_of([](auto, float a, float b) { return (a + b) / 2; });
  const Image third = made_of([](auto, float a, float b) { return 0.7F * a + 0.3F * b; });
  const Image noisy_copy = made_of([](auto, float a, float b) { return b + a - 1; });
  const Image half_copied = made_of([](auto pixel, float a, float b) { return pixel % 128 < 64 ? a : b; });
  for (const auto& [image, share] : {std::pair{own, 0.0},
                                     {without_variance(own), 0.0},
                                     {blend, 0.5},
                                     {third, 0.3},
                                     {noisy_copy, 1.0},
                                     {half_copied, 0.5}}) {
    const auto test = test_noise(image, reference);
    ASSERT_TRUE(test.shared_noise);
    constexpr double kTooSmall = 0.05;
    EXPECT_LE(test.shared_noise->low, share);
    EXPECT_GE(test.shared_noise->high, share - kTooSmall);
    EXPECT_LT(test.shared_noise->high - test.shared_noise->low, 0.5);
    EXPECT_EQ(holds_reference_noise(test), share > 0) << share;
  }
}

// Nothing where the reference is exact, or shows detail beyond its noise.
TEST(NoiseTest, NoImageOfItsOwnHoldsNoiseOfTheReference) {
  for (const auto& light : {Light(from_half_to_three_halves), Light(penumbra), Light(fireflies)}) {
    const Image reference = rendered(light, {.size_px = 40, .spp = 256, .seed = kReferenceSeed});
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      const Image own = rendered(light, {.size_px = 40, .seed = seed});
      EXPECT_FALSE(holds_reference_noise(test_noise(own, reference))) << seed;
      EXPECT_FALSE(holds_reference_noise(test_noise(brighter(own, 1.05F), reference))) << seed;
    }
    Image overstated = reference;
    for (std::size_t i = 0; i < overstated.pixels.size(); ++i)
      if (i % 6 >= 3) overstated.pixels[i] *= 4;
    EXPECT_FALSE(holds_reference_noise(test_noise(rendered(light, {.size_px = 40}), overstated)));
    EXPECT_FALSE(test_noise(reference, without_variance(reference)).shared_noise);
  }
}

// What is in proportion to detail is an error, or none, and no noise.
TEST(NoiseTest, DetailIsNoNoiseOfTheReference) {
  const Light textured = [](std::uint64_t key, int pixel) {
    return 1 + 0.2 * (unit_random(mix(key, 1)) - 0.5) +
           0.02 * unit_random(mix(77, static_cast<std::uint64_t>(pixel)));
  };
  const Image reference = rendered(textured, {.size_px = 64, .spp = 4096, .seed = kReferenceSeed});
  Image contrast = rendered(textured, {.size_px = 64, .spp = 1024});
  for (std::size_t i = 0; i < contrast.pixels.size(); ++i)
    if (i % 6 < 3) contrast.pixels[i] = 1 + (contrast.pixels[i] - 1) * 1.1F;
  EXPECT_FALSE(test_noise(contrast, reference).shared_noise);
}

// The attributes of an image may say what they like: the noise is in its pixels.
TEST(NoiseTest, NoWordOfTheImageChangesItsNoise) {
  const Image reference =
      rendered(from_half_to_three_halves, {.size_px = 64, .spp = 256, .seed = kReferenceSeed});
  Image result = rendered(from_half_to_three_halves, {.size_px = 64});
  const double before = test_noise(result, reference).noise_squared;
  result.attributes["orbs.spp"] = "1";
  EXPECT_EQ(test_noise(result, reference).noise_squared, before);
}

TEST(Seeds, GiveTheMeanAndTheVarianceOfTheMean) {
  std::vector<Image> renders;
  for (const float value : {1.0F, 2.0F, 6.0F}) {
    renders.push_back(orbs::image::make_image(2, 1, {"R", "G", "B"}));
    renders.back().pixels.assign(6, value);
  }
  for (auto& render : renders) render.attributes = {{"orbs.spp", "8"}, {"orbs.bad_samples", "2"}};
  renders.back().attributes.erase("orbs.bad_samples");
  const Image mean = mean_and_variance_of(renders);
  EXPECT_EQ(mean.attributes.at("orbs.spp"), "24");
  EXPECT_FALSE(mean.attributes.contains("orbs.bad_samples")) << "one of them does not say";
  EXPECT_EQ(mean.at(0, 0, 0), 3.0F);
  // Squared distances 4 + 1 + 9 = 14, by n - 1 = 2, by n = 3.
  EXPECT_FLOAT_EQ(mean.at(1, 0, 3), 14.0F / 6);
}

TEST(Seeds, KeepEveryLayerAndTheVarianceOfStokesParameters) {
  std::vector<Image> renders;
  for (const float value : {1.0F, 3.0F}) {
    renders.push_back(
        orbs::image::make_image(1, 1, {"R", "G", "B", "variance.R", "S1.R", "A", "path.EDL.G"}));
    renders.back().pixels = {value, 1, 1, 9, -value, value / 4, 2 * value};
  }
  const Image mean = mean_and_variance_of(renders);
  const auto of = [&](const char* channel) {
    const int index = orbs::image::channel_index(mean, channel);
    return index < 0 ? -100.0F : mean.at(0, 0, static_cast<std::size_t>(index));
  };
  EXPECT_EQ(of("R"), 2.0F);
  EXPECT_EQ(of("variance.R"), 1.0F);  // that of the scatter, not the 9 that they state
  EXPECT_EQ(of("S1.R"), -2.0F);
  EXPECT_EQ(of("variance.S1.R"), 1.0F);
  EXPECT_EQ(of("A"), 0.5F);
  EXPECT_EQ(of("path.EDL.G"), 4.0F);
  EXPECT_EQ(mean.channel_count(), 10U);
  renders.back().channels.back() = "path.EDL.B";
  EXPECT_THROW(mean_and_variance_of(renders), orbs::InputError);
}

TEST(Seeds, TwoAreEnoughToJudgeAnImageBy) {
  const Image reference =
      rendered(from_half_to_three_halves, {.size_px = 64, .spp = 256, .seed = kReferenceSeed});
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Image mean = mean_and_variance_of(
        {without_variance(rendered(from_half_to_three_halves, {.size_px = 64, .seed = seed})),
         without_variance(rendered(from_half_to_three_halves, {.size_px = 64, .seed = seed + 100}))});
    EXPECT_FALSE(is_biased(test_noise(mean, reference))) << seed;
    EXPECT_TRUE(mean_error(test_noise(brighter(mean, 1.01F), reference))) << seed;
  }
}

TEST(Seeds, OfARendererThatIgnoresThemAreRefused) {
  const Image one = rendered(from_half_to_three_halves, {});
  EXPECT_THROW(mean_and_variance_of({one}), orbs::InputError);
  EXPECT_THROW(mean_and_variance_of({one, one}), orbs::InputError);
  EXPECT_THROW(mean_and_variance_of({one, rendered(from_half_to_three_halves, {.size_px = 8})}),
               orbs::InputError);
}
