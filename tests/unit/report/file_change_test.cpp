#include "report/file_change.h"

#include <string>

#include <gtest/gtest.h>

using orbs::report::unified_diff;

namespace {

std::string numbers(int first, int last) {
  std::string text;
  for (int i = first; i <= last; ++i) text += std::to_string(i) + "\n";
  return text;
}

}  // namespace

TEST(UnifiedDiff, HasThreeLinesOfContext) {
  EXPECT_EQ(unified_diff(numbers(1, 9), numbers(1, 4) + "new\n" + numbers(6, 9), "f"),
            "--- f\n+++ f\n@@ -2,7 +2,7 @@\n 2\n 3\n 4\n-5\n+new\n 6\n 7\n 8\n");
}

TEST(UnifiedDiff, HasFewerAtTheEndsOfTheFile) {
  EXPECT_EQ(unified_diff("a\n", "a\nb\n", "f"), "--- f\n+++ f\n@@ -1 +1,2 @@\n a\n+b\n");
  EXPECT_EQ(unified_diff("", "b\n", "f"), "--- f\n+++ f\n@@ -0,0 +1 @@\n+b\n");
  EXPECT_EQ(unified_diff("a\nb\n", "b\n", "f"), "--- f\n+++ f\n@@ -1,2 +1 @@\n-a\n b\n");
}

// A line that is repeated belongs to what is before the change or to what is after it, not to both.
TEST(UnifiedDiff, CountsARepeatedLineOnce) {
  EXPECT_EQ(unified_diff("a\n", "a\na\n", "f"), "--- f\n+++ f\n@@ -1 +1,2 @@\n a\n+a\n");
}

TEST(UnifiedDiff, SaysThatTheLastLineHasNoEnd) {
  EXPECT_EQ(unified_diff("a", "a\n", "f"),
            "--- f\n+++ f\n@@ -1 +1 @@\n-a\n\\ No newline at end of file\n+a\n");
}

TEST(UnifiedDiff, IsEmptyForEqualTexts) { EXPECT_EQ(unified_diff("a\n", "a\n", "f"), ""); }
