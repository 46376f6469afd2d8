#include "base/text_table.h"

#include <gtest/gtest.h>

using namespace orbs;

TEST(TextTable, ColumnsAreAsWideAsTheirWidestCellAndLinesEndWithoutSpaces) {
  EXPECT_EQ(text_table({{"a", "bb", "c"}, {"aaa", "b", ""}, {}, {"x"}}), "a    bb  c\naaa  b\n\nx\n");
}

TEST(TextTable, MarkdownHasARuleBelowItsHead) {
  EXPECT_EQ(markdown_table({{"a", "b"}, {"1", "2"}}), "| a | b |\n|---|---|\n| 1 | 2 |\n");
  EXPECT_EQ(markdown_table({}), "");
}

TEST(TextTable, NumbersStandAtTheRightOfTheirColumn) {
  EXPECT_EQ(text_table({{"time", "n"}, {"\u00b5s", "12.5"}}, {Align::Left, Align::Right}),
            "time     n\n\u00b5s    12.5\n");
}
