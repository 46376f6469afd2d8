#include "json/document.h"

#include "base/error.h"
#include "base/text.h"
#include "json/object_reader.h"

#include <string>

#include <gtest/gtest.h>

namespace {

using namespace orbs;

std::string complaint_about(const std::string& text) {
  try {
    json::parse("a.json", text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(JsonDocument, WhatTheParserAloneNoticesHasItsPlaceToo) {
  EXPECT_EQ(complaint_about("{\"a\": 1,\n  \"a\": 2}"),
            "a.json:2:5: key 'a' appears twice in one object\n  \"a\": 2}\n    ^");
  EXPECT_TRUE(complaint_about("{\"a\":\n 1e999}").starts_with("a.json:2:7: not usable JSON: "))
      << complaint_about("{\"a\":\n 1e999}");
  const std::string deep(70, '[');
  EXPECT_TRUE(complaint_about(deep).starts_with("a.json:1:66: nested deeper than 64 levels"))
      << complaint_about(deep);
}

TEST(JsonDocument, ComplaintsAreFreeOfTheLibrarysOwnNames) {
  EXPECT_TRUE(
      complaint_about("{\"a\": rot}").starts_with("a.json:1:7: not valid JSON: syntax error while parsing"))
      << complaint_about("{\"a\": rot}");
  for (const char* text : {"rot", "{\"a\": 1e999}", "[1,", "{'a': 1}"})
    EXPECT_EQ(complaint_about(text).find("json.exception"), std::string::npos) << complaint_about(text);
}

TEST(JsonDocument, AnEmptyFileIsCalledOne) {
  for (const char* text : {"", " \n\t\n"})
    EXPECT_TRUE(std::string(complaint_about(text))
                    .starts_with("a.json:1:1: the file is empty, expected a JSON object"))
        << complaint_about(text);
}

// Files that programs write are often one line, and nobody wants it on the terminal.
TEST(JsonDocument, OfALongLineOnlyTheSurroundingsAreShown) {
  const std::string space(100000, ' ');
  const auto complaint = complaint_about("{" + space + "x" + space + "}");
  EXPECT_LT(complaint.size(), 1000U);
  EXPECT_TRUE(complaint.ends_with("\n" + std::string(100, ' ') + "x" + std::string(99, ' ') + "\n" +
                                  std::string(100, ' ') + "^"))
      << complaint;
}

TEST(JsonDocument, TextForTheSystemHoldsNoZeroByte) {
  const auto document = json::parse("a.json", R"({"path": "a\u0000b", "words": ["a", "b\u0000"]})");
  json::ObjectReader in(document);
  EXPECT_EQ(in.text("path"), std::string("a\0b", 3));
  EXPECT_THROW(in.system_text("path"), InputError);
  EXPECT_THROW(in.system_texts("words"), InputError);
}

TEST(JsonDocument, EachValueIsWhereItsKeysSay) {
  const auto document = json::parse(
      "a.json",
      R"({"a": {"b": [[1, 2], {"c": {}, "d": [3, {"e": "x"}]}], "f": null}, "g": [{}, {"h": true}]})");
  json::ObjectReader in(document);
  auto a = in.object("a");
  EXPECT_FALSE(a.holds_number("f"));
  EXPECT_FALSE(a.holds_objects("b"));
  EXPECT_THROW(a.objects("b"), InputError);
  auto g = in.objects("g");
  ASSERT_EQ(g.size(), 2U);
  EXPECT_TRUE(g[0].keys().empty());
  EXPECT_TRUE(g[1].boolean_or("h", false));
}

// Comparing them letter by letter would take hours.
TEST(Text, NobodyIsAskedWhetherHeMeantAWordOfAMegabyte) {
  EXPECT_EQ(closest("radios", {"radius", std::string(1 << 20, 'a')}), " (did you mean 'radius'?)");
  EXPECT_EQ(closest(std::string(1 << 20, 'b'), {std::string(1 << 20, 'a')}), "");
}
