#include "base/statistics.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

// One degree of freedom is Cauchy's distribution: 1 - 2/pi atan(t). Two: 1 - t / sqrt(t^2 + 2).
TEST(StudentT, HasTheClosedFormsOfOneAndTwoDegrees) {
  for (const double t : {0.0, 0.1, 1.0, 3.0, 20.0}) {
    EXPECT_NEAR(orbs::student_tail(t, 1), 1 - 2 / M_PI * std::atan(t), 1e-12) << t;
    EXPECT_NEAR(orbs::student_tail(-t, 2), 1 - t / std::sqrt(t * t + 2), 1e-12) << t;
  }
  EXPECT_EQ(orbs::student_tail(std::numeric_limits<double>::infinity(), 5), 0);
}

// Two-sided values of the usual table.
TEST(StudentT, HasTheQuantilesOfTheTable) {
  EXPECT_NEAR(orbs::student_quantile(0.05, 1), 12.7062, 1e-4);
  EXPECT_NEAR(orbs::student_quantile(0.05, 10), 2.22814, 1e-5);
  EXPECT_NEAR(orbs::student_quantile(0.01, 30), 2.75000, 1e-5);
  EXPECT_NEAR(orbs::student_quantile(0.001, 4), 8.61030, 1e-5);
}

// Many degrees are the normal distribution, far out as well: 2 (1 - Phi(z)) = erfc(z / sqrt 2).
TEST(StudentT, BecomesTheNormalDistribution) {
  for (const double z : {0.5, 2.0, 4.0, 6.0})
    EXPECT_NEAR(orbs::student_tail(z, 1e7) / std::erfc(z / std::sqrt(2.0)), 1, 1e-4) << z;
}
