#include "json/locate.h"

#include "json/text_index.h"

#include <gtest/gtest.h>

using orbs::json::with_element;

TEST(WithElement, StandsAfterTheLastIndentedLikeIt) {
  EXPECT_EQ(with_element("{\n  \"a\": [\n    { \"x\": 1 }\n  ],\n  \"b\": []\n}\n", "/a", "{\n  \"x\": 2\n}"),
            "{\n  \"a\": [\n    { \"x\": 1 },\n    {\n      \"x\": 2\n    }\n  ],\n  \"b\": []\n}\n");
}

TEST(WithElement, TurnsAnEmptyArrayIntoLines) {
  EXPECT_EQ(with_element("{\n  \"a\": [ ]\n}\n", "/a", "3"), "{\n  \"a\": [\n    3\n   ]\n}\n");
  EXPECT_EQ(with_element("[]", "", "3"), "[\n  3\n]");
}

TEST(WithElement, TakesNoBracketOfATextForItsOwn) {
  EXPECT_EQ(with_element(R"({"a": ["]", "[\"]"], "b": "]"})", "/a", "1"),
            "{\"a\": [\"]\", \"[\\\"]\",\n1\n], \"b\": \"]\"}");
}

TEST(TextIndex, FindsWhatLocateFinds) {
  const std::string text = R"( {"a": [ {"b": 1,
   "c/d": [[], [2, "x\n", {"~": 3}]] },
 {} ], "a~1": {
  "": 5}, "e": []})";
  orbs::json::TextIndex index;
  for (const char* pointer :
       {"", "/a", "/a/0", "/a/0/b", "/a/0/c~1d", "/a/0/c~1d/1/2/~0", "/a/1", "/a/1/missing", "/a/7", "/a~01",
        "/a~01/", "/e", "/e/0", "/nowhere/at/all", "/a/0/b/c"}) {
    const auto expected = orbs::json::locate(text, pointer);
    const auto found = index.locate(text, pointer);
    EXPECT_EQ(found.line, expected.line) << pointer;
    EXPECT_EQ(found.column, expected.column) << pointer;
  }
}
