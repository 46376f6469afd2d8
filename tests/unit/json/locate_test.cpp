#include "json/locate.h"

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
