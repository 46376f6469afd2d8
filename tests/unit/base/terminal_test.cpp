// Text of strangers on the terminal.
#include "base/terminal.h"

#include "base/text.h"
#include "base/text_table.h"

#include <cstdlib>

#include <gtest/gtest.h>

using namespace orbs;

TEST(CleanText, MarksWhatMovesTheCursorOrReordersTheLine) {
  EXPECT_EQ(clean_text("a\x1b]0;title\x07z"), "a\uFFFD]0;title\uFFFDz");
  EXPECT_EQ(clean_text("good\rbad"), "good\uFFFDbad");
  EXPECT_EQ(clean_text("a\r\nb\tc"), "a\r\nb\tc");
  EXPECT_EQ(clean_text("a\u202egpj.exe"), "a\uFFFDgpj.exe");
  EXPECT_EQ(clean_text("a\u2066b\u2069c\u200fd\u061ce"), "a\uFFFDb\uFFFDc\uFFFDd\uFFFDe");
  EXPECT_EQ(clean_text("\xff\xc2\x9b"), "\uFFFD\uFFFD");
  EXPECT_EQ(clean_text("\u00c9mission \u2265 \u05d0"), "\u00c9mission \u2265 \u05d0");
}

TEST(CleanLine, IsOneLine) { EXPECT_EQ(clean_line("R\nG\r\nB\t"), "R G  B "); }

TEST(TerminalText, KeepsTheColoursOfOurTablesOnly) {
  EXPECT_EQ(terminal_text("\x1b[32mpass\x1b[0m \x1b[8mhidden \x1b[2J"),
            "\x1b[32mpass\x1b[0m \uFFFD[8mhidden \uFFFD[2J");
}

TEST(TextTable, CellsOfStrangersAreCleanAndStayOnTheirLine) {
  EXPECT_EQ(text_table({{"a\nb", "\x1b[31mred"}, {"c", "d"}}), "a b  \uFFFD[31mred\nc    d\n");
}

TEST(TextTable, LinesWiderThanTheTerminalAreBrokenBetweenWordsOfTheLastColumn) {
  const std::vector<TableRow> rows{{"fail", "one two three four five six seven eight nine"}, {"x", "y"}};
  EXPECT_EQ(text_table(rows, {}, {40, {}}),
            "fail  one two three four five six seven\n"
            "      eight nine\n"
            "x     y\n");
  const std::vector<TableRow> wide{{"a column as wide as that", "one two three four five six seven eight"}};
  EXPECT_EQ(text_table(wide, {}, {40, {}}),
            "a column as wide as that\n"
            "      one two three four five six seven\n"
            "      eight\n");
}

TEST(TextTable, ColoursAreAroundTheTextAndCountForNothing) {
  EXPECT_EQ(text_table({{"pass", "a"}, {"failed", "b"}}, {}, {0, {{{0, 0}, colour::kGreen}}}),
            "\x1b[32mpass\x1b[0m    a\nfailed  b\n");
}

TEST(TerminalWidth, IsNoneWhereThereIsNoTerminal) {
  ::unsetenv("COLUMNS");
  EXPECT_EQ(terminal_width(-1), 0);
}

TEST(TextTable, ColumnsWithoutRoomGoOnBelowAndNoNumberIsCut) {
  const std::vector<TableRow> rows{{"scene", "first time", "second time", "what happens"},
                                   {"ball", "0.59 s (0.58-0.61)", "2.5 s (2.3-2.6)", "one two three four"},
                                   {"lamp", "1 s", "", ""}};
  EXPECT_EQ(text_table(rows, {}, {40, {}}),
            "scene  first time\n"
            "      second time      what happens\n"
            "ball   0.59 s (0.58-0.61)\n"
            "      2.5 s (2.3-2.6)  one two three\n"
            "                       four\n"
            "lamp   1 s\n");
}

TEST(TextTables, HaveAsManyColumnsAsThereIsRoomForAndTheirColours) {
  const std::vector<TableRow> rows{{"G1", "orbs 12.5", "cycles 33", "povray 4"}};
  const TableLook look{24, {{{0, 3}, colour::kRed}}};
  EXPECT_EQ(text_tables(rows, 1, look), "G1  orbs 12.5  cycles 33\n\nG1  \x1b[31mpovray 4\x1b[0m\n");
  EXPECT_EQ(text_tables(rows, 1, {0, {}}), "G1  orbs 12.5  cycles 33  povray 4\n");
}

TEST(WrappedLines, WhatGoesOnIsIndented) {
  EXPECT_EQ(wrapped_lines("one two three four\nfive\n", 10), "one two\n  three\n  four\nfive\n");
  EXPECT_EQ(wrapped_lines("one two three four\n", 0), "one two three four\n");
  EXPECT_EQ(wrapped_lines("", 10), "");
}

TEST(TerminalStyle, NoColourAndNoTerminalLeaveTheTextAsItIs) {
  EXPECT_FALSE(terminal_style(-1).colour);
  EXPECT_EQ(painted("fail", colour::kRed, {false, 80}), "fail");
  EXPECT_EQ(painted("fail", "", {true, 80}), "fail");
  EXPECT_EQ(painted("fail", colour::kRed, {true, 80}), "\x1b[31mfail\x1b[0m");
}
