#include "base/pattern.h"

#include "base/error.h"

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

TEST(Pattern, SaysWhetherALineMatches) {
  EXPECT_TRUE(Pattern("not found|ERROR").matches("HydraScene ERROR: x"));
  EXPECT_FALSE(Pattern("^ERROR").matches("HydraScene ERROR: x"));
  EXPECT_FALSE(Pattern("x").matches(std::string(1001, 'x')));
}

TEST(Pattern, IsMatchedLineByLine) {
  EXPECT_EQ(Pattern("^t ([0-9])$").last_match("t 1\nt 2 \nx t 3\n"), Groups{"1"});
  EXPECT_EQ(Pattern("a(.*)b").last_match("a1\n2b\na3b\n"), Groups{"3"});
  EXPECT_EQ(Pattern("^([0-9])").last_match("12\n"), Groups{"1"});  // 2 is no start of a line
}

TEST(Pattern, ThatMatchesNothingEverywhereEndsAllTheSame) {
  EXPECT_EQ(Pattern("(x*)").last_match("ab\nx\n").size(), 1U);
}

// The line of progress of a renderer is rewritten after each carriage return.
TEST(Pattern, TakesACarriageReturnForTheEndOfALine) {
  EXPECT_EQ(Pattern("^\\(([0-9.]+)s\\) *$").last_match("(1s|9s)\r(2.5s)  \r\nend\r\n"), Groups{"2.5"});
}

// A renderer may print anything. The library would search a megabyte of this for minutes, and this test would
// reach its time limit.
TEST(Pattern, SearchesNoLineThatIsLongerThanAnyMessage) {
  std::string line;
  while (line.size() < 1000000) line += "error ";
  const Pattern pattern("(error)[^:]*: *[^ ]");
  EXPECT_TRUE(pattern.last_match(line).empty());
  EXPECT_EQ(pattern.last_match("error: a\n" + line + '\n'), Groups{"error"});
}

TEST(Pattern, ThatIsNoneIsRefusedWithTheReason) {
  try {
    Pattern("took ([0-9");
    FAIL();
  } catch (const orbs::InputError& e) {
    EXPECT_TRUE(std::string(e.what()).starts_with("'took ([0-9' is no regular expression: ")) << e.what();
  }
}

TEST(Pattern, ThatWouldOverflowTheLibraryOrNeverEndIsRefused) {
  const auto problem_of = [](const std::string& text) -> std::string {
    try {
      Pattern pattern(text);
    } catch (const orbs::InputError& e) {
      return e.what();
    }
    return "";
  };
  std::string deep;
  for (int i = 0; i < 20000; ++i) deep += '(';
  EXPECT_NE(problem_of(deep).find("more than 50 groups"), std::string::npos);
  EXPECT_NE(problem_of("(a{1,255}){1,255}{1,255}").find("more than 10000 characters"), std::string::npos);
  EXPECT_NE(problem_of("((a{1,255}){1,255}){3}").find("more than 10000 characters"), std::string::npos);
  EXPECT_NE(problem_of("(a*)*\\1").find("refers back"), std::string::npos);
  EXPECT_EQ(problem_of("[]{}({]{255}"), "");
  EXPECT_EQ(problem_of("[[:digit:]{]+ \\((a{1,20}){1,20}\\)"), "");
  EXPECT_EQ(problem_of("a{2,}b{,3}|^c?"), "");
}
