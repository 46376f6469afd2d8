#include "registry/features.h"

#include "base/error.h"

#include <gtest/gtest.h>

using orbs::InputError;
using orbs::registry::FeatureSet;
using orbs::registry::format_features;
using orbs::registry::parse_features;

namespace {

std::string message_of(const std::string& text) {
  try {
    parse_features(text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace

// The two examples of ORB.S section 1, with what the specification says they mean.
TEST(FeatureNumbers, ExamplesOfTheSpecificationMeanWhatItSays) {
  EXPECT_EQ(parse_features("G1/M3/L7-(2,3)"),
            (FeatureSet{{'G', {1}}, {'M', {1, 2, 3}}, {'L', {1, 4, 5, 6, 7}}}));
  EXPECT_EQ(parse_features("L7+(11-13, 15-18)"),
            (FeatureSet{{'L', {1, 2, 3, 4, 5, 6, 7, 11, 12, 13, 15, 16, 17, 18}}}));
}

TEST(FeatureNumbers, AreWrittenInTheShortestForm) {
  EXPECT_EQ(format_features({{'L', {1, 4, 5, 6, 7}}}), "L7-(2,3)");
  EXPECT_EQ(format_features({{'L', {1, 2, 3, 4, 5, 6, 7, 11, 12, 13, 15, 16, 17, 18}}}), "L18-(8-10,14)");
  EXPECT_EQ(format_features({{'L', {1, 2, 3, 4, 5, 6, 7, 11, 15}}}), "L7+(11,15)");
  EXPECT_EQ(format_features({{'M', {1, 2, 3, 4, 5, 6, 7, 8}}}), "M8");
  EXPECT_EQ(format_features({{'M', {3}}}), "M0+(3)");
  EXPECT_EQ(format_features({{'M', {1, 2, 3, 5, 6, 7, 9}}}), "M9-(4,8)");
  EXPECT_EQ(format_features({{'M', {}}}), "M0");
  EXPECT_EQ(format_features({{'M', {1, 3}}}, {{'M', {2, 7}}, {'L', {1}}}), "M3?(2,7)/L?");
}

TEST(FeatureNumbers, OfTwoEquallyShortFormsTheHigherLevelIsWritten) {
  EXPECT_EQ(format_features({{'L', {1, 3}}}), "L3-(2)");  // as long as L1+(3)
}

TEST(FeatureNumbers, GroupsStandInTheOrderOfTheSpecificationAndOwnGroupsBehind) {
  EXPECT_EQ(format_features({{'A', {1}}, {'E', {1}}, {'G', {1}}, {'L', {1}}, {'M', {1}}}), "G1/M1/L1/A1/E1");
}

TEST(FeatureNumbers, ErrorsSayWhatIsWrongAndWhatIsExpected) {
  const std::string expected = "; expected for example G1, L7-(2,3) or L7+(11-13,15)";
  EXPECT_EQ(
      message_of("G1/m3"),
      "feature number 'm3': each part between '/' starts with the capital letter of a group" + expected);
  EXPECT_EQ(message_of("Gx"), "feature number 'Gx': 'x' is no number" + expected);
  EXPECT_EQ(message_of("G"), "feature number 'G': '' is no number" + expected);
  EXPECT_EQ(message_of("L3-(4)"), "feature number 'L3-(4)': 4 is left out but not among 1 to 3" + expected);
  EXPECT_EQ(message_of("L3+(2)"), "feature number 'L3+(2)': 2 is added but already among 1 to 3" + expected);
  EXPECT_EQ(message_of("L3-(3-2)"), "feature number 'L3-(3-2)': the range '3-2' runs backwards" + expected);
  EXPECT_EQ(message_of("L3-(2,2)"), "feature number 'L3-(2,2)': 2 is listed twice" + expected);
  EXPECT_EQ(message_of("L3-2"), "feature number 'L3-2': a list in brackets must follow + or -" + expected);
  EXPECT_EQ(message_of("L3-(2"), "feature number 'L3-(2': a list in brackets must follow + or -" + expected);
  EXPECT_EQ(message_of("L1/L2"), "feature number 'L2': group L stands there twice" + expected);
  EXPECT_EQ(message_of("L100"), "feature number 'L100': 100 does not lie in [0, 99]" + expected);
}

TEST(FeatureNumbers, RequirementCodesAreALetterAndANumber) {
  const auto code = orbs::registry::parse_requirement("M7");
  EXPECT_EQ(code.group, 'M');
  EXPECT_EQ(code.level, 7);
  for (const char* wrong : {"", "M", "m7", "M0", "M7x", "7M", "M-1"})
    EXPECT_THROW(orbs::registry::parse_requirement(wrong), InputError) << wrong;
}

TEST(FeatureNumbers, ARequirementIsHadOnlyWhereItsNumberIs) {
  const auto features = parse_features("G2/L4-(2)");
  EXPECT_TRUE(orbs::registry::has_feature(features, {'L', 3}));
  EXPECT_FALSE(orbs::registry::has_feature(features, {'L', 2}));
  EXPECT_FALSE(orbs::registry::has_feature(features, {'M', 1}));
}
