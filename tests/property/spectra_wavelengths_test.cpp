// Sampled wavelengths: the density is the one that is stated, and what paths estimate with them is unbiased
// and quiet.
#include "base/nth.h"
#include "base/random.h"
#include "spectra/observer.h"
#include "spectra/rgb.h"
#include "spectra/wavelengths.h"
#include "tracer/sampling/sampler.h"
#include "tracer/transport/spectral_transport.h"
#include "unit/spectra/tables.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::spectra;

using tracer::Float4;
using tracer::SpectralTransport;

// What a path whose wavelengths come from `u` tells of a surface in the light.
Vec3d estimate(const Spectrum& reflectance, const Spectrum& light, float u, bool drops = false) {
  auto lambda = SpectralTransport::sample_lambda([&] { return u; });
  Float4 weight{1, 1, 1, 1};
  if (drops) SpectralTransport::terminate_secondary(lambda, weight);
  Float4 seen{};
  for (std::size_t i = 0; i < 4; ++i)
    seen[i] = static_cast<float>(value_at(reflectance, lambda.nm[i]) * value_at(light, lambda.nm[i]));
  return cast<double>(SpectralTransport::to_rgb(weight * seen, lambda));
}

// Mean of `count` estimates at evenly spread numbers: the expected value but for an error that falls with
// count^2.
Vec3d expected_colour(const Spectrum& reflectance, const Spectrum& light, int count, bool drops) {
  Vec3d sum;
  for (int i = 0; i < count; ++i)
    sum += estimate(reflectance, light, (static_cast<float>(i) + 0.5F) / static_cast<float>(count), drops);
  return sum / count;
}

}  // namespace

TEST(Wavelengths, AreWhereTheEyeSeesAndStratified) {
  for (const float u : {0.0F, 0.1F, 0.24999F, 0.5F, 0.75F, 0.99999994F}) {
    const Wavelengths wavelengths = sample_wavelengths(u);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_GE(wavelengths.nm[i], 360);
      EXPECT_LE(wavelengths.nm[i], 830);
      EXPECT_GT(wavelengths.pdf[i], 0);
      EXPECT_NEAR(wavelengths.nm[i],
                  sample_wavelengths(std::fmod(u + 0.25F * static_cast<float>(i), 1.0F)).nm[0], 1e-3);
    }
  }
  EXPECT_EQ(sample_wavelengths(0).nm[0], 360);
}

// 1 / pdf is the derivative of the wavelength by the number that it is made from.
TEST(Wavelengths, TheDensityIsTheDerivativeOfTheMap) {
  for (int i = 1; i < 4095; ++i) {
    const float u = (static_cast<float>(i) + 0.25F) / 4096;
    const Wavelengths here = sample_wavelengths(u);
    const double slope =
        (static_cast<double>(sample_wavelengths(u + 1.0F / 16384).nm[0]) - here.nm[0]) * 16384;
    EXPECT_NEAR(1 / slope, here.pdf[0], here.pdf[0] * 0.03) << here.nm[0];  // nm are rounded to 3e-5
  }
}

TEST(Wavelengths, TheEstimateOfEveryPatchIsUnbiasedWithAndWithoutCompanions) {
  for (const std::string_view name : {"D65", "A"})
    for (const Spectrum& patch : colorchecker())
      for (const bool drops : {false, true}) {
        const Spectrum& light = illuminant(name);
        const Vec3d expected = rgb_of_xyz(xyz_of_reflectance(patch, light));
        EXPECT_LT(largest_magnitude(expected_colour(patch, light, 1 << 15, drops) - expected), 1e-5)
            << name << (drops ? " without companions" : "");
      }
}

TEST(Wavelengths, CompanionsAreDroppedOnce) {
  auto lambda = SpectralTransport::sample_lambda([] { return 0.3F; });
  Float4 weight{2, 1, 1, 1};
  for (int i = 0; i < 2; ++i) SpectralTransport::terminate_secondary(lambda, weight);
  EXPECT_EQ(weight[0], 8);
  EXPECT_EQ(weight[1] + weight[2] + weight[3], 0);
}

// 64 samples of a pixel, one in each of 64 strata; white is 1. Noise: root of the mean squared error over 64
// pixels.
TEST(Wavelengths, TheColorCheckerIsQuietAt64StratifiedSamples) {
  constexpr int kPixels = 64;
  constexpr int kSamples = 64;
  double worst = 0;
  for (const Spectrum& patch : colorchecker()) {
    const Spectrum& light = illuminant("D65");
    const Vec3d expected = rgb_of_xyz(xyz_of_reflectance(patch, light));
    Vec3d squares;
    for (std::uint64_t pixel = 0; pixel < kPixels; ++pixel) {
      Vec3d sum;
      for (std::uint64_t i = 0; i < kSamples; ++i) {
        const double u = (static_cast<double>(i) + unit_random(mix(pixel, i))) / kSamples;
        sum += estimate(patch, light, static_cast<float>(u));
      }
      const Vec3d error = sum / kSamples - expected;
      squares += error * error;
    }
    worst = std::max(worst, std::sqrt(largest(squares) / kPixels));
  }
  EXPECT_LT(worst, 0.01);
  RecordProperty("worst_channel_noise", fmt::format("{:.2e}", worst));
}

// Independent numbers instead: what one path alone is worth. The bound is 2 % above what was measured when
// the density was chosen; a density of uniform wavelengths reaches 0.69.
TEST(Wavelengths, OnePathOnGreyHasTheNoiseThatTheDensityWasChosenFor) {
  constexpr int kCount = 1 << 14;
  Vec3d squares;
  for (int i = 0; i < kCount; ++i) {
    const float u = (static_cast<float>(i) + 0.5F) / kCount;
    const Vec3d error = estimate(constant(1), illuminant("D65"), u) - Vec3d{1, 1, 1};
    squares += error * error;
  }
  EXPECT_LT(std::sqrt((squares.x + squares.y + squares.z) / (3 * kCount)), 0.0975);
}

// The samples of a pixel together: the first numbers of Sobol' points place 4 n wavelengths in 4 n strata,
// and white is all but exact after sixteen of them.
TEST(Wavelengths, SamplesOfAPixelShareNoStratum) {
  constexpr std::uint32_t kSamples = 16;
  Vec3d squares;
  constexpr std::uint32_t kPixels = 64;
  for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
    const auto block = tracer::sample_block(1, pixel, 0);
    std::array<int, 4 * kSamples> hits{};
    std::array<int, kSamples> heroes{};
    Vec3d sum;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
      const auto point = tracer::draw(block, i, 0, tracer::SampleDimension::Wavelength);
      const float u = wavelength_number(point[0], point[1]);
      ++nth(heroes, static_cast<int>(u * kSamples));
      for (const float turn : {0.0F, 0.25F, 0.5F, 0.75F})
        ++nth(hits, static_cast<int>(std::fmod(u + turn, 1.0F) * 4 * kSamples));
      sum += estimate(constant(1), illuminant("D65"), u);
    }
    for (const int count : hits) EXPECT_EQ(count, 1) << pixel;
    for (const int count : heroes) EXPECT_EQ(count, 1) << pixel;
    const Vec3d error = sum / kSamples - Vec3d{1, 1, 1};
    squares += error * error;
  }
  EXPECT_LT(std::sqrt(largest(squares) / kPixels), 0.006);
}

TEST(Wavelengths, TheirNumberIsBelowOne) {
  EXPECT_LT(wavelength_number(1 - 0x1p-24F, 1 - 0x1p-24F), 1);
  EXPECT_EQ(wavelength_number(0, 0), 0);
}
