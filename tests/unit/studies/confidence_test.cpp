#include "studies/seed_statistics.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

using namespace orbs::studies;

TEST(Interval, OfAMedianLiesBetweenOrderStatistics) {
  const auto nine = median_interval({9, 1, 8, 2, 7, 3, 6, 4, 5});
  EXPECT_EQ(nine.value, 5);
  EXPECT_EQ(nine.low, 2) << "of nine values, the second and the eighth enclose the median in 96 %";
  EXPECT_EQ(nine.high, 8);
  const auto four = median_interval({4, 1, 3, 2});
  EXPECT_EQ(four.value, 2.5);
  EXPECT_EQ(four.low, 1);
  EXPECT_EQ(four.high, 4);
  EXPECT_EQ(median_interval({3}).low, 3);
}

TEST(Interval, OfAMeanHoldsItIn95Percent) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(10, 2);
  int held = 0;
  constexpr int kTrials = 2000;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto found = mean_interval({normal(random), normal(random), normal(random), normal(random)});
    held += found.low <= 10 && 10 <= found.high ? 1 : 0;
  }
  EXPECT_GE(held, kTrials * 93 / 100);
  EXPECT_LE(held, kTrials * 97 / 100);
}

// The test that compares a renderer with itself: at 1 % outside, about 1 of 100 equal pairs looks different.
TEST(Interval, OfARatioCallsEqualSamplesDifferentAsOftenAsItStates) {
  std::mt19937 random(5);
  std::lognormal_distribution<double> time(0, 0.05);
  int called = 0;
  constexpr int kPairs = 4000;
  for (int pair = 0; pair < kPairs; ++pair) {
    std::vector<double> first, second;
    for (int i = 0; i < 4; ++i) {
      first.push_back(time(random));
      second.push_back(time(random));
    }
    const auto ratio = ratio_interval(first, second, 0.01);
    called += ratio.low > 1 || ratio.high < 1 ? 1 : 0;
  }
  EXPECT_LE(called, kPairs * 15 / 1000);
  EXPECT_GE(called, kPairs * 4 / 1000);
}

TEST(Interval, OfARatioIsOfGeometricMeans) {
  const auto ratio = ratio_interval({1, 4}, {4, 16});
  EXPECT_NEAR(ratio.value, 4, 1e-12);
  EXPECT_LT(ratio.low, 4);
  EXPECT_GT(ratio.high, 4);
}
