#include "tracer/sampling/sampler.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

using namespace orbs::tracer;

namespace {

// What is drawn once for a path, and what at every bounce.
constexpr std::array kOfPaths{SampleDimension::PixelAndFirstLight, SampleDimension::LightPick,
                              SampleDimension::Wavelength};
constexpr std::array kOfBounces{SampleDimension::Light, SampleDimension::Scatter,
                                SampleDimension::MirroredLight, SampleDimension::Reradiation};

}  // namespace

TEST(Sampler, NumbersLieInTheHalfOpenUnitInterval) {
  for (std::uint32_t pixel = 0; pixel < 200; ++pixel)
    for (std::uint32_t i = 0; i < 64; ++i)
      for (const float x : draw(sample_block(1, pixel, 0), i, pixel % 7, kOfBounces[i % 4])) {
        EXPECT_GE(x, 0.0F);
        EXPECT_LT(x, 1.0F);
      }
}

// Owen scrambling and shuffling keep each dimension a (0, m, 1)-net: 2^m points, one in each interval of
// length 2^-m.
TEST(Sampler, EachDimensionIsStratifiedForEveryPowerOfTwo) {
  for (std::uint32_t count = 2; count <= 1024; count *= 2)
    for (std::size_t d = 0; d < 4; ++d) {
      std::set<int> cells;
      for (std::uint32_t i = 0; i < count; ++i)
        cells.insert(static_cast<int>(draw(sample_block(3, 17, 0), i, 2, SampleDimension::Scatter)[d] *
                                      static_cast<float>(count)));
      EXPECT_EQ(cells.size(), count) << "dimension " << d;
    }
}

// The first two Sobol' dimensions form a (0, 2)-sequence: 16 points, one in each cell of 1x16, 2x8, 4x4, 8x2
// and 16x1.
TEST(Sampler, TheFirstTwoDimensionsAreStratifiedTogether) {
  for (int columns = 1; columns <= 16; columns *= 2) {
    std::set<std::pair<int, int>> cells;
    for (std::uint32_t i = 0; i < 16; ++i) {
      const auto u = draw(sample_block(5, 99, 1), i, 0, SampleDimension::PixelAndFirstLight);
      cells.emplace(static_cast<int>(u[0] * static_cast<float>(columns)),
                    static_cast<int>(u[1] * (16.0F / static_cast<float>(columns))));
    }
    EXPECT_EQ(cells.size(), 16U) << columns << " columns";
  }
}

TEST(Sampler, PixelsReplicatesBouncesAndPurposesAreIndependent) {
  std::set<std::array<float, 4>> first;
  int count = 0;
  const auto note = [&](SampleBlock block, std::uint32_t bounce, SampleDimension dimension) {
    first.insert(draw(block, 0, bounce, dimension));
    ++count;
  };
  for (std::uint32_t pixel = 0; pixel < 4; ++pixel)
    for (std::uint32_t replicate = 0; replicate < 4; ++replicate) {
      const auto block = sample_block(1, pixel, replicate);
      for (const SampleDimension dimension : kOfPaths) note(block, 0, dimension);
      for (std::uint32_t bounce = 0; bounce < 16; ++bounce)
        for (const SampleDimension dimension : kOfBounces) note(block, bounce, dimension);
    }
  EXPECT_EQ(static_cast<int>(first.size()), count);
}

// The mean of x over a replicate has the exact expectation 1/2; correlation between dimensions of different
// purposes would show in the mean product of unrelated numbers, which must be 1/4.
TEST(Sampler, NumbersOfDifferentBouncesAreUncorrelated) {
  double product = 0;
  constexpr int kPixels = 4000;
  for (std::uint32_t pixel = 0; pixel < kPixels; ++pixel) {
    const auto block = sample_block(11, pixel, 0);
    for (std::uint32_t i = 0; i < 16; ++i)
      product += static_cast<double>(draw(block, i, 0, SampleDimension::Scatter)[0]) *
                 draw(block, i, 1, SampleDimension::Scatter)[0];
  }
  product /= 16.0 * kPixels;
  EXPECT_NEAR(product, 0.25, 4 * 0.22 / std::sqrt(16.0 * kPixels));  // sd of a product of two uniforms: 0.22
}
