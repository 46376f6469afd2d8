#include "registry/placeholders.h"

#include <gtest/gtest.h>

using orbs::registry::fill_placeholders;
using orbs::registry::placeholder_problem;

TEST(Placeholders, AreReplacedWhereverTheyStandInAWord) {
  EXPECT_EQ(fill_placeholders("--output={output}:{spp}", {{"output", "/a b"}, {"spp", "4"}}),
            "--output=/a b:4");
}

TEST(Placeholders, AValueThatLooksLikeAPlaceholderIsLeftAlone) {
  EXPECT_EQ(fill_placeholders("{scene}", {{"scene", "{spp}"}, {"spp", "4"}}), "{spp}");
}

TEST(Placeholders, DoubledBracesAreBraces) {
  EXPECT_EQ(placeholder_problem("{{x}}", {}), std::nullopt);
  EXPECT_EQ(fill_placeholders("{{x}}", {}), "{x}");
}

TEST(Placeholders, AnUnknownOneIsNamedWithTheNearestAndAll) {
  EXPECT_EQ(placeholder_problem("{sene}", {"scene", "spp"}),
            "unknown placeholder {sene} (did you mean 'scene'?); known are: scene, spp");
}

TEST(Placeholders, ABraceWithoutPartnerIsRefused) {
  EXPECT_EQ(placeholder_problem("{scene", {"scene"}),
            "'{' has no partner; write {{ for the character itself");
  EXPECT_EQ(placeholder_problem("scene}", {"scene"}),
            "'}' has no partner; write }} for the character itself");
}
