#include "base/error.h"
#include "base/pattern.h"

#include <gtest/gtest.h>

using orbs::Pattern;
using Groups = std::vector<std::string>;

TEST(Pattern, GivesTheGroupsOfTheLastMatch) {
  const Pattern pattern("took ([0-9.]+) s(econds)?");
  EXPECT_EQ(pattern.group_count(), 2U);
  EXPECT_EQ(pattern.last_match("took 1.5 s\nit took 2.25 seconds\nthe end\n"), (Groups{"2.25", "econds"}));
  EXPECT_EQ(pattern.last_match("took 1.5 s\ntook long\n"), (Groups{"1.5", ""}));
  EXPECT_TRUE(pattern.last_match("nothing").empty());
  EXPECT_TRUE(pattern.last_match("").empty());
}

TEST(Pattern, IsMatchedLineByLine) {
  EXPECT_EQ(Pattern("^t ([0-9])$").last_match("t 1\nt 2 \nx t 3\n"), Groups{"1"});
  EXPECT_EQ(Pattern("a(.*)b").last_match("a1\n2b\na3b\n"), Groups{"3"});
  EXPECT_EQ(Pattern("^([0-9])").last_match("12\n"), Groups{"1"});  // 2 is no start of a line
}

TEST(Pattern, ThatMatchesNothingEverywhereEndsAllTheSame) {
  EXPECT_EQ(Pattern("(x*)").last_match("ab\nx\n").size(), 1U);
}

TEST(Pattern, ThatIsNoneIsRefusedWithTheReason) {
  try {
    Pattern("took ([0-9");
    FAIL();
  } catch (const orbs::InputError& e) {
    EXPECT_TRUE(std::string(e.what()).starts_with("'took ([0-9' is no regular expression: ")) << e.what();
  }
}
