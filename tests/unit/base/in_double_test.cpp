#include "base/in_double.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace {

namespace in_double = orbs::in_double;

// Of the values to more digits than a double has, the nearest floats.
TEST(InDouble, IsTheNearestFloat) {
  EXPECT_EQ(in_double::sin(1.0F), 0x1.aed548p-1F);           // 0.841470984807896507
  EXPECT_EQ(in_double::cos(1.0F), 0x1.14a280p-1F);           // 0.540302305868139717
  EXPECT_EQ(in_double::asin(0.5F), 0x1.0c1524p-1F);          // pi / 6
  EXPECT_EQ(in_double::acos(0.0F), 0x1.921fb6p+0F);          // pi / 2
  EXPECT_EQ(in_double::atan2(1.0F, -1.0F), 0x1.2d97c8p+1F);  // 3 pi / 4
  EXPECT_EQ(in_double::pow(2.0F, 0.5F), 0x1.6a09e6p+0F);     // 1.414213562373095049
  EXPECT_EQ(in_double::hypot(1.0F, 1.0F), 0x1.6a09e6p+0F);
}

TEST(InDouble, ADoubleStaysADouble) { EXPECT_EQ(in_double::sin(1.0), std::sin(1.0)); }

TEST(InDouble, ALengthNeitherOverflowsNorVanishes) {
  constexpr float kMax = std::numeric_limits<float>::max();
  constexpr float kMin = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(in_double::hypot(kMax / 2, 0.0F), kMax / 2);
  EXPECT_FLOAT_EQ(in_double::hypot(0.6F * kMax, 0.6F * kMax), std::sqrt(2.0F) * 0.6F * kMax);
  EXPECT_EQ(in_double::hypot(3 * kMin, 4 * kMin), 5 * kMin);
}

}  // namespace
