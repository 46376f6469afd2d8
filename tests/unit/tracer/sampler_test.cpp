#include "tracer/sampling/sampler.h"

#include <cmath>
#include <set>
#include <utility>

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

TEST(Sampler, PixelsBlocksBouncesAndPurposesAreIndependent) {
  std::set<std::array<float, 4>> first;
  int count = 0;
  const auto note = [&](SampleBlock block, std::uint32_t bounce, SampleDimension dimension) {
    first.insert(draw(block, 0, bounce, dimension));
    ++count;
  };
  for (std::uint32_t pixel = 0; pixel < 4; ++pixel)
    for (std::uint32_t number = 0; number < 4; ++number) {
      const auto block = sample_block(1, pixel, number);
      for (const SampleDimension dimension : kOfPaths) note(block, 0, dimension);
      for (std::uint32_t bounce = 0; bounce < 16; ++bounce)
        for (const SampleDimension dimension : kOfBounces) note(block, bounce, dimension);
    }
  EXPECT_EQ(static_cast<int>(first.size()), count);
}

// The mean of x over a block has the exact expectation 1/2; correlation between dimensions of different
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

namespace {

constexpr std::array kSamplers{Sampler::Independent, Sampler::Stratified, Sampler::Sobol};

// Points of a block of `count`.
std::vector<std::array<float, 4>> points_of(Sampler sampler, std::uint32_t count, SampleDimension dimension) {
  const auto block = sample_block(7, 21, 0, {sampler, count});
  std::vector<std::array<float, 4>> points;
  for (std::uint32_t i = 0; i < count; ++i) points.push_back(draw(block, i, 3, dimension));
  return points;
}

std::size_t occupied_cells(const std::vector<std::array<float, 4>>& points,
                           std::size_t first,
                           float columns,
                           float rows) {
  std::set<std::pair<int, int>> cells;
  for (const auto& point : points)
    cells.emplace(static_cast<int>(point[first] * columns), static_cast<int>(point[first + 1] * rows));
  return cells.size();
}

}  // namespace

TEST(Sampler, EightPathsGetTheNumbersOfEach) {
  for (const Sampler sampler : kSamplers) {
    SampleBlocks blocks{{}, {sampler, 16}};
    Word8 indices{};
    for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
      blocks.seeds[lane] = sample_block(7, lane, 0).seed;
      indices[lane] = 15 - lane;
    }
    const auto together = draw(blocks, indices, 2, SampleDimension::Light);
    for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
      const auto alone = draw({blocks.seeds[lane], blocks.points}, indices[lane], 2, SampleDimension::Light);
      for (std::size_t d = 0; d < 4; ++d) EXPECT_EQ(together[d][lane], alone[d]);
    }
  }
}

// Numbers that are used as a pair fill a grid, and single ones an interval each; 12 is no square, and its
// grid of 3 x 4 is full as well.
TEST(StratifiedSampler, PairsFillAGridAndSingleNumbersAnIntervalEach) {
  for (const std::uint32_t count : {12U, 16U}) {
    const float columns = count == 12 ? 3 : 4;
    const auto first = points_of(Sampler::Stratified, count, SampleDimension::PixelAndFirstLight);
    EXPECT_EQ(occupied_cells(first, 0, columns, 4), count);
    EXPECT_EQ(occupied_cells(first, 2, columns, 4), count);
    EXPECT_EQ(occupied_cells(points_of(Sampler::Stratified, count, SampleDimension::Scatter), 0, columns, 4),
              count);
    const auto light = points_of(Sampler::Stratified, count, SampleDimension::Light);
    EXPECT_EQ(occupied_cells(light, 1, columns, 4), count);
    for (const std::size_t single : {0U, 3U}) {
      std::set<int> intervals;
      for (const auto& point : light)
        intervals.insert(static_cast<int>(point[single] * static_cast<float>(count)));
      EXPECT_EQ(intervals.size(), count);
    }
  }
}

TEST(IndependentSampler, LeavesIntervalsEmptyAsRandomNumbersDo) {
  const auto points = points_of(Sampler::Independent, 1024, SampleDimension::Scatter);
  for (std::size_t d = 0; d < 4; ++d) {
    std::set<int> intervals;
    for (const auto& point : points) intervals.insert(static_cast<int>(point[d] * 1024));
    // 1024 (1 - 1/e) = 647 in the mean, with a standard deviation of 10.
    EXPECT_NEAR(static_cast<double>(intervals.size()), 647, 40);
  }
}

// Each number of each sampler is uniform whatever the number of points; 7 leaves cells of the grid empty.
TEST(Sampler, EveryNumberOfABlockIsUniform) {
  constexpr int kBlocks = 4000;
  for (const Sampler sampler : kSamplers)
    for (const SampleDimension dimension : {SampleDimension::PixelAndFirstLight, SampleDimension::Light}) {
      std::array<std::array<double, 7>, 4> sums{};
      for (std::uint32_t pixel = 0; pixel < kBlocks; ++pixel)
        for (std::uint32_t i = 0; i < 7; ++i) {
          const auto u = draw(sample_block(1, pixel, 0, {sampler, 7}), i, 0, dimension);
          for (std::size_t d = 0; d < 4; ++d) sums[d][i] += static_cast<double>(u[d]) / kBlocks;
        }
      for (const auto& of_dimension : sums)
        for (const double mean : of_dimension)
          EXPECT_NEAR(mean, 0.5, 4.5 * std::sqrt(1.0 / 12 / kBlocks));  // 168 means
    }
}
