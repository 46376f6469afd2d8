#include "base/error.h"
#include "base/random.h"
#include "references/store.h"
#include "references/unfinished.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace orbs;
using references::add_pass;
using references::mean_image;
using references::PassSum;

namespace {

const std::vector<std::string> kChannels{"R", "G", "B", "variance.R", "variance.G", "variance.B"};

image::Image flat(float value, float variance, int width = 4) {
  auto image = image::make_image(width, 4, kChannels);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = i % kChannels.size() < 3 ? value : variance;
  return image;
}

// Grey with noise as a reference has it. The variances spread over eight octaves, as those of an image do;
// the mean of 2^(8u - 4) over u in [0, 1) is 2.87.
image::Image noisy_grey(double mean, double deviation) {
  auto image = image::make_image(64, 64, kChannels);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const double u = unit_random(mix(7, i));
    image.pixels[i] =
        static_cast<float>(i % kChannels.size() < 3 ? mean + deviation * std::sqrt(12.0) * (u - 0.5)
                                                    : deviation * deviation / 2.87 * std::exp2(8 * u - 4));
  }
  return image;
}

}  // namespace

// 10 samples of mean 1 and 30 of mean 2: (10 + 60) / 40. Variances 0.3 and 0.1: (100 * 0.3 + 900 * 0.1) /
// 1600.
TEST(Passes, AreWeightedByTheirSamples) {
  PassSum sum;
  add_pass(sum, flat(1, 0.3F), {10, 1});
  add_pass(sum, flat(2, 0.1F), {30, 2});
  const auto mean = mean_image(sum);
  EXPECT_EQ(sum.spp, 40);
  EXPECT_EQ(mean.channels, kChannels);
  EXPECT_FLOAT_EQ(mean.at(3, 2, 0), 1.75F);
  EXPECT_FLOAT_EQ(mean.at(3, 2, 4), 0.075F);
}

// n samples of variance s^2 have the mean's variance s^2 / n, however they are split into passes.
TEST(Passes, HaveTheVarianceOfOneRenderWithAllTheirSamples) {
  PassSum sum;
  for (const int spp : {8, 24, 96}) add_pass(sum, flat(1, 2.0F / static_cast<float>(spp)), {spp, 1});
  EXPECT_FLOAT_EQ(mean_image(sum).at(0, 0, 3), 2.0F / 128);
}

TEST(Passes, OneAloneIsTheImageItself) {
  PassSum sum;
  const auto image = noisy_grey(0.3, 0.01);
  add_pass(sum, image, {7, 1});
  EXPECT_EQ(mean_image(sum).pixels, image.pixels);
}

TEST(Passes, AClassOfPathsThatOnePassLacksIsBlackInIt) {
  auto with_layer = image::make_image(2, 2, {"R", "G", "B", "path.ESDL.R"});
  std::fill(with_layer.pixels.begin(), with_layer.pixels.end(), 4.0F);
  for (const bool layer_first : {true, false}) {
    PassSum sum;
    add_pass(sum, layer_first ? with_layer : flat(1, 0, 2), {10, 1});
    if (layer_first) {
      add_pass(sum, image::make_image(2, 2, {"R", "G", "B"}), {30, 2});
      const auto mean = mean_image(sum);
      EXPECT_EQ(mean.channels.back(), "path.ESDL.R");
      EXPECT_EQ(mean.at(1, 1, 3), 1.0F);
    } else {
      EXPECT_THROW(add_pass(sum, with_layer, {30, 2}), InputError);  // 2 x 2 after 2 x 4 pixels
    }
  }
}

TEST(Passes, CountTheirBadSamplesTogether) {
  PassSum sum;
  auto image = flat(1, 0);
  image.attributes["orbs.bad_samples"] = "3";
  add_pass(sum, image, {10, 1});
  add_pass(sum, image, {10, 2});
  EXPECT_EQ(sum.bad_samples, 6);
}

// The derivation beside the code: 68 dB and more, against 45 dB of noise.
TEST(ShortenedImage, IsFarBelowTheNoiseOfAReference) {
  const auto image = noisy_grey(0.4, 0.005);
  const auto shortened = references::shortened_image(image);
  double squares = 0;
  double variances = 0;
  double shortened_variances = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const double difference = static_cast<double>(shortened.pixels[i]) - static_cast<double>(image.pixels[i]);
    if (i % 6 < 3) {
      squares += difference * difference;
    } else {
      variances += static_cast<double>(image.pixels[i]);
      shortened_variances += static_cast<double>(shortened.pixels[i]);
    }
  }
  EXPECT_LT(squares, 0.01 * variances);
  EXPECT_NE(squares, 0);
  EXPECT_NEAR(shortened_variances / variances, 1, 0.02);
}

TEST(ShortenedImage, KeepsColoursWithoutNoiseAndWhatFits) {
  const auto lamp = references::shortened_image(flat(0.8F, 0));
  EXPECT_EQ(lamp.at(0, 0, 1), 0.8F);
  const auto half = references::shortened_image(flat(0.75F, 0.375F));
  EXPECT_EQ(half.at(0, 0, 1), 0.75F);
  EXPECT_EQ(half.at(0, 0, 4), 0.375F);
  EXPECT_NE(references::shortened_image(flat(0.8F, 1e-6F)).at(0, 0, 1), 0.8F);
}

// A colour of 0.02 with 1 % of noise has a variance of 4e-8, which as a half is 6e-8, and one of 0.001 none.
TEST(StoredReference, IsOfHalvesUnlessTheyLoseItsVariances) {
  const auto precision_of = [](float value, float variance) {
    return references::precision_of(references::shortened_image(flat(value, variance)));
  };
  EXPECT_EQ(precision_of(0.8F, 0), image::Precision::Half);
  EXPECT_EQ(precision_of(0.8F, 1e-5F), image::Precision::Half);
  EXPECT_EQ(precision_of(0.02F, 4e-8F), image::Precision::Float);
  EXPECT_EQ(precision_of(0.001F, 1e-10F), image::Precision::Float);
  EXPECT_EQ(precision_of(1e5F, 1), image::Precision::Float);
}

TEST(ShortenedImage, HasNoLayersButItsProvenance) {
  auto image =
      image::make_image(2, 2, {"R", "G", "B", "variance.R", "variance.G", "variance.B", "path.EDL.R"});
  image.attributes["orbs.seed"] = "7";
  const auto shortened = references::shortened_image(image);
  EXPECT_EQ(shortened.channels, kChannels);
  EXPECT_EQ(shortened.attributes, image.attributes);
}

TEST(ShortenedImage, KeepsStokesParametersButNotTheColourTwice) {
  auto image = image::make_image(
      1, 1, {"R", "G", "B", "variance.R", "variance.G", "variance.B", "S1.R", "S0.R", "S3.B"});
  image.pixels = {0.5F, 0.5F, 0.5F, 0.1F, 0.1F, 0.1F, -0.25F, 0.5F, 0.125F};
  const auto shortened = references::shortened_image(image);
  EXPECT_EQ(image::channel_index(shortened, "S0.R"), -1);
  EXPECT_EQ(shortened.at(0, 0, static_cast<std::size_t>(image::channel_index(shortened, "S1.R"))), -0.25F);
  EXPECT_EQ(shortened.at(0, 0, static_cast<std::size_t>(image::channel_index(shortened, "S3.B"))), 0.125F);
}

// Layers of 3/4 and 1/4 of the light.
TEST(PathShares, AreSharesOfTheMeanRadiance) {
  auto image = image::make_image(2, 1,
                                 {"R", "G", "B", "path.EDL.R", "path.EDL.G", "path.EDL.B", "path.other.R",
                                  "path.other.G", "path.other.B"});
  for (int x = 0; x < 2; ++x)
    for (std::size_t c = 0; c < 9; ++c) image.at(x, 0, c) = c < 3 ? 1.0F : c < 6 ? 0.75F : 0.25F;
  const auto shares = references::path_shares(image);
  EXPECT_EQ(shares.size(), 2U);
  EXPECT_DOUBLE_EQ(shares.at("EDL"), 0.75);
  EXPECT_DOUBLE_EQ(shares.at("other"), 0.25);
}
