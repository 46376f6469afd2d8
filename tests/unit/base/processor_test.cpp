#include "base/processor.h"

#include <string>

#include <gtest/gtest.h>

#if defined(__x86_64__)

namespace {

using orbs::missing_instructions;
using orbs::ProcessorFeatures;

// What CPUID answers on a Haswell (Core i7-4770), as the Intel manual names the bits.
constexpr ProcessorFeatures kHaswell{0x7ffafbff, 0x000027ab, 0x00000021, 7};

TEST(Processor, OfThisTestHasAllThatIsNeeded) {
  EXPECT_EQ(missing_instructions(orbs::features_of_this_processor()), nullptr);
}

TEST(Processor, OfThe2013KindHasAllThatIsNeeded) { EXPECT_EQ(missing_instructions(kHaswell), nullptr); }

// An Ivy Bridge of 2012 has AVX and F16C.
TEST(Processor, OlderOnesLackWhatIsNamed) {
  EXPECT_STREQ(missing_instructions({0x7fbae3ff, 0x00000281, 0x00000001, 7}), "AVX2");
  EXPECT_STREQ(missing_instructions({0x029ee3ff, 0, 0x00000001, 0}), "AVX");  // Westmere
  EXPECT_STREQ(missing_instructions({}), "SSE3");
}

TEST(Processor, ASystemThatDoesNotSaveTheWideRegistersIsNamed) {
  auto features = kHaswell;
  features.saved = 3;
  EXPECT_NE(std::string(missing_instructions(features)).find("does not save"), std::string::npos);
}

}  // namespace

#endif
