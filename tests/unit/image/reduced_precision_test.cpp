#include "image/reduced_precision.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

using orbs::image::float_of_half;
using orbs::image::half_bits;
using orbs::image::rounded_to_bits;

// IEEE 754 binary16: sign, 5 bits of exponent with bias 15, 10 of significand.
TEST(Half, IsTheNumberThatItsBitsSay) {
  for (std::uint32_t bits = 0; bits < 0x7c00; ++bits) {
    const int exponent = static_cast<int>(bits >> 10);
    const auto fraction = static_cast<float>(bits & 0x3ff);
    const float value =
        exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
    ASSERT_EQ(float_of_half(static_cast<std::uint16_t>(bits)), value) << bits;
    ASSERT_EQ(float_of_half(static_cast<std::uint16_t>(bits | 0x8000)), -value) << bits;
    ASSERT_EQ(half_bits(value), bits);
    ASSERT_EQ(half_bits(-value), bits | 0x8000);
  }
}

TEST(Half, IsTheNearestAndEvenOfTwoThatAreAsNear) {
  for (std::uint32_t bits = 0; bits < 0x7c00; ++bits) {
    const float low = float_of_half(static_cast<std::uint16_t>(bits));
    const float high = bits == 0x7bff ? 65536.0F : float_of_half(static_cast<std::uint16_t>(bits + 1));
    const float middle = (low + high) / 2;
    ASSERT_EQ(half_bits(middle), bits + (bits & 1)) << bits;
    ASSERT_EQ(half_bits(std::nextafter(middle, 0.0F)), bits) << bits;
    ASSERT_EQ(half_bits(std::nextafter(middle, 1e30F)), bits + 1) << bits;
    ASSERT_EQ(half_bits(-middle), (bits + (bits & 1)) | 0x8000) << bits;
  }
  EXPECT_EQ(half_bits(1e-30F), 0);
  EXPECT_EQ(half_bits(std::numeric_limits<float>::denorm_min()), 0);
}

TEST(Half, KeepsInfinitiesAndWhatIsNoNumber) {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(half_bits(kInf), 0x7c00);
  EXPECT_EQ(half_bits(-kInf), 0xfc00);
  EXPECT_EQ(half_bits(1e30F), 0x7c00);
  EXPECT_EQ(float_of_half(0x7c00), kInf);
  EXPECT_EQ(float_of_half(0xfc00), -kInf);
  EXPECT_EQ(half_bits(std::numeric_limits<float>::quiet_NaN()), 0x7e00);
  for (std::uint32_t bits = 0x7c01; bits < 0x8000; ++bits) {
    ASSERT_TRUE(std::isnan(float_of_half(static_cast<std::uint16_t>(bits)))) << bits;
    ASSERT_EQ(half_bits(float_of_half(static_cast<std::uint16_t>(bits))), bits | 0x200) << bits;
  }
}

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
