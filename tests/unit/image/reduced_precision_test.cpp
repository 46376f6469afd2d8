#include "image/reduced_precision.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

using orbs::image::rounded_to_bits;

TEST(Rounding, GoesToTheNearestOfTheValuesWithThatManyBits) {
  EXPECT_EQ(rounded_to_bits(1.2F, 2), 1.0F);  // between 1 and 1.5
  EXPECT_EQ(rounded_to_bits(1.3F, 2), 1.5F);
  EXPECT_EQ(rounded_to_bits(-1.3F, 2), -1.5F);
  EXPECT_EQ(rounded_to_bits(1.9F, 2), 2.0F);  // the carry changes the exponent
  for (const float x : {1e-30F, 0.0217F, 0.7F, 3.9999F, 65000.0F})
    EXPECT_NEAR(rounded_to_bits(x, 9), x, x * 0x1p-9F);
}

TEST(Rounding, LeavesWhatFitsExact) {
  for (const float x : {0.0F, 0.5F, 0.75F, 1.0F, 40.0F, 511.0F, 0x1.01p-20F})
    EXPECT_EQ(rounded_to_bits(x, 9), x);
  EXPECT_TRUE(std::signbit(rounded_to_bits(-0.0F, 9)));
  EXPECT_TRUE(std::isnan(rounded_to_bits(std::nanf(""), 9)));
  EXPECT_TRUE(std::isinf(rounded_to_bits(std::numeric_limits<float>::infinity(), 9)));
}
