#include "registry/features.h"

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

TEST(FeatureNotation, NoSubsetHasAShorterTextThanTheOneThatIsWritten) {
  // All texts "M<base>-(...)+(...)" of a subset with their lists in the shortest form are tried by their
  // base; here against the two plain ones, whose lengths can be counted without the code under test:
  // everything added to M0, and everything left out of M8.
  for (unsigned bits = 1; bits < 256; ++bits) {
    const auto text = format_features({{'M', levels_of(bits)}});
    const auto added = format_features({{'M', levels_of(bits)}}).size();
    EXPECT_LE(text.size(), std::string("M0+()").size() + 2 * levels_of(bits).size() - 1) << text;
    EXPECT_LE(added, std::string("M8-()").size() + 2 * (8 - levels_of(bits).size()) - (bits == 255 ? 0 : 1))
        << text;
  }
}

TEST(FeatureNotation, SeveralGroupsReadBackInAnyOrder) {
  for (unsigned bits = 0; bits < 256; bits += 5) {
    const FeatureSet features{
        {'G', levels_of(bits)}, {'A', levels_of(255 - bits)}, {'S', levels_of(bits / 2)}};
    EXPECT_EQ(parse_features(format_features(features)), features);
  }
}
