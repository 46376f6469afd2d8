#include "base/two_digits.h"

#include <limits>

#include <gtest/gtest.h>

using orbs::two_digits;

// "about 2.7e+04 times the samples" stood in the line of a render.
TEST(TwoDigits, HaveNoExponent) {
  EXPECT_EQ(two_digits(0), "0");
  EXPECT_EQ(two_digits(2.84), "2.8");
  EXPECT_EQ(two_digits(28.4), "28");
  EXPECT_EQ(two_digits(99.6), "100");
  EXPECT_EQ(two_digits(123), "120");
  EXPECT_EQ(two_digits(996), "1000");
  EXPECT_EQ(two_digits(27123), "27000");
  EXPECT_EQ(two_digits(std::numeric_limits<double>::infinity()), "inf");
}
