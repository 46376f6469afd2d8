#include "studies/cost/error_fit.h"

#include "studies/seed_statistics.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

using namespace orbs::studies;
using orbs::Interval;

namespace {

struct Truth {
  double bias_squared;
  double variance;
  double exponent;
};

constexpr int kRungs = 6;
constexpr int kSeeds = 4;
constexpr double kRelative = 0.06;  // deviation of the squared error of one image from its mean
constexpr double kReferenceNoise = 1e-6;

double error_at(const Truth& truth, double seconds) {
  return truth.bias_squared + truth.variance * std::pow(seconds, -truth.exponent);
}

// The fit of one study in which every image's squared error scatters around what the truth gives.
std::optional<ErrorFit> fit_of_trial(const Truth& truth, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<std::vector<double>> errors(kRungs);
  double relative_squares = 0;
  for (int k = 0; k < kRungs; ++k) {
    const double mean = error_at(truth, std::pow(2.0, k)) + kReferenceNoise;
    for (int i = 0; i < kSeeds; ++i)
      errors.at(static_cast<std::size_t>(k)).push_back(mean * (1 + kRelative * normal(random)));
    const auto sample = sample_of(errors.at(static_cast<std::size_t>(k)));
    relative_squares += sample.variance / (sample.mean * sample.mean) / kRungs;
  }
  std::vector<FitPoint> points;
  for (int k = 0; k < kRungs; ++k)
    points.push_back({std::pow(2.0, k),
                      sample_of(errors.at(static_cast<std::size_t>(k))).mean - kReferenceNoise,
                      kReferenceNoise, relative_squares / kSeeds});
  return fit_error(points, kRungs * (kSeeds - 1));
}

bool holds(const Interval& interval, double truth) { return interval.low <= truth && truth <= interval.high; }

void expect_coverage(int held, int trials, const char* what) {
  EXPECT_GE(held, trials * 93 / 100) << what;
  EXPECT_LE(held, trials * 97 / 100) << what;
}

}  // namespace

class ErrorFitCoverage : public testing::TestWithParam<Truth> {};

// Between 93 % and 97 % of the stated 95 % intervals hold the truth.
TEST_P(ErrorFitCoverage, IsWhatTheIntervalsState) {
  constexpr int kTrials = 1000;
  std::mt19937 random(7);
  int bias = 0, variance = 0, exponent = 0, floors = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto fit = fit_of_trial(GetParam(), random);
    ASSERT_TRUE(fit);
    bias += holds(fit->bias_squared, GetParam().bias_squared) ? 1 : 0;
    variance += holds(fit->variance, GetParam().variance) ? 1 : 0;
    exponent += holds(fit->exponent, GetParam().exponent) ? 1 : 0;
    floors += fit->has_floor ? 1 : 0;
  }
  expect_coverage(bias, kTrials, "bias^2");
  expect_coverage(variance, kTrials, "variance");
  expect_coverage(exponent, kTrials, "exponent");
  if (GetParam().bias_squared == 0) {
    EXPECT_LE(floors, 5) << "a floor is called in 1 of 1000 without one";
  }
  if (GetParam().bias_squared > 5e-4) {
    EXPECT_GE(floors, 900);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Truths,
    ErrorFitCoverage,
    testing::Values(Truth{0, 0.01, 1}, Truth{1e-3, 0.01, 1}, Truth{1e-4, 0.01, 1.5}, Truth{0, 1e-3, 0.67}));

TEST(ErrorFit, NeedsFourPoints) {
  EXPECT_FALSE(fit_error({{1, 1, 0, 1e-4}, {2, 0.5, 0, 1e-4}, {4, 0.25, 0, 1e-4}}, 9));
}

// A curve with a corner is not b^2 + v / t^p: the intervals must widen beyond what the noise gives.
TEST(ErrorFit, WidensItsIntervalsWhereTheCurveDoesNotFit) {
  const auto points_with = [](double corner) {
    std::vector<FitPoint> points;
    for (int k = 0; k < 8; ++k)
      points.push_back({std::pow(2.0, k), std::pow(2.0, -k) * (k % 2 == 0 ? 1 : corner), 0, 1e-4});
    return points;
  };
  const auto smooth = fit_error(points_with(1), 24);
  const auto cornered = fit_error(points_with(1.3), 24);
  ASSERT_TRUE(smooth && cornered);
  EXPECT_GT(cornered->misfit, 20);
  EXPECT_GT(cornered->exponent.high - cornered->exponent.low,
            4 * (smooth->exponent.high - smooth->exponent.low));
}
