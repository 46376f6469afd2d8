#include "registry/features.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

using orbs::registry::FeatureSet;
using orbs::registry::format_features;
using orbs::registry::parse_features;

namespace {

std::set<int> levels_of(unsigned bits) {
  std::set<int> levels;
  for (int level = 1; level <= 8; ++level)
    if ((bits >> (level - 1) & 1U) != 0) levels.insert(level);
  return levels;
}

}  // namespace

TEST(FeatureNotation, EverySubsetOfEightLevelsReadsBackAsItself) {
  for (unsigned bits = 0; bits < 256; ++bits) {
    const FeatureSet features{{'M', levels_of(bits)}};
    EXPECT_EQ(parse_features(format_features(features)), features) << format_features(features);
  }
}

// The two plain texts, whose lengths need no code under test: everything added to M0 ("M0+(1,2)"), and
// everything left out of M8 ("M8-(3,4)").
TEST(FeatureNotation, NoSubsetIsLongerThanItsPlainTexts) {
  for (unsigned bits = 1; bits < 255; ++bits) {
    const auto levels = levels_of(bits);
    const auto text = format_features({{'M', levels}});
    EXPECT_LE(text.size(), std::string("M0+()").size() + 2 * levels.size() - 1) << text;
    EXPECT_LE(text.size(), std::string("M8-()").size() + 2 * (8 - levels.size()) - 1) << text;
  }
}

TEST(FeatureNotation, SeveralGroupsReadBackInAnyOrder) {
  for (unsigned bits = 0; bits < 256; bits += 5) {
    const FeatureSet features{
        {'G', levels_of(bits)}, {'A', levels_of(255 - bits)}, {'S', levels_of(bits / 2)}};
    EXPECT_EQ(parse_features(format_features(features)), features);
  }
}
