#include "json/layers.h"

#include "base/error.h"
#include "json/object_reader.h"

#include <gtest/gtest.h>

using namespace orbs;

namespace {

json::Document whole_of(const std::vector<std::string>& texts) {
  std::vector<json::Document> documents;
  for (std::size_t i = 0; i < texts.size(); ++i)
    documents.push_back(json::parse("file" + std::to_string(i), texts[i]));
  return json::layered(
      std::move(documents), {.by_name = {"items"}, .appended = {"notes"}},
      [](std::size_t /*layer*/, const std::string& /*pointer*/, const std::string& text) { return text; });
}

std::string complaint(json::ObjectReader in, const std::string& key) {
  try {
    in.fail(key, "wrong");
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(Layers, KeysOfObjectsTakeThePlaceOfThoseBelow) {
  const auto whole =
      whole_of({R"({"a": {"x": 1, "y": 2}, "b": [1, 2]})", "{\"a\": {\n\"y\": 3}, \"b\": [4]}"});
  json::ObjectReader in(whole);
  auto a = in.object("a");
  EXPECT_EQ(a.number("x"), 1);
  EXPECT_EQ(a.number("y"), 3);
  EXPECT_EQ(in.numbers("b"), std::vector<double>{4});
  EXPECT_EQ(a.place("x"), "file0:1");
  EXPECT_EQ(a.place("y"), "file1:2");
}

TEST(Layers, NullTakesAKeyAwayAndIsRefusedWhereThereIsNone) {
  const auto whole = whole_of({R"({"a": {"x": 1, "y": 2}})", R"({"a": {"y": null, "z": null}})"});
  auto a = json::ObjectReader(whole).object("a");
  EXPECT_EQ(a.keys(), (std::vector<std::string>{"x", "z"}));
  EXPECT_THROW(a.number("z"), InputError);
}

TEST(Layers, ElementsOfOneNameAreOneAndOthersAreAdded) {
  const auto whole = whole_of(
      {R"({"items": [{"name": "a", "x": {"p": 1, "q": 2}}, {"name": "b"}], "notes": [{"n": 1}]})",
       "{\"items\": [\n{\"name\": \"c\", \"x\": {}},\n{\"name\": \"a\",\n\"x\": {\"q\": 5}}],\n\"notes\": [\n{\"n\": 2}]}"});
  json::ObjectReader in(whole);
  auto items = in.objects("items");
  ASSERT_EQ(items.size(), 3U);
  EXPECT_EQ(items[0].text("name"), "a");
  EXPECT_EQ(items[0].object("x").number("p"), 1);
  EXPECT_EQ(items[0].object("x").number("q"), 5);
  EXPECT_EQ(items[2].text("name"), "c");
  auto notes = in.objects("notes");
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[1].place("n"), "file1:6");
  EXPECT_TRUE(complaint(items[0].object("x"), "q").starts_with("file1:4:12: /items/1/x/q: wrong"))
      << complaint(items[0].object("x"), "q");
  EXPECT_TRUE(complaint(items[0].object("x"), "p").starts_with("file0:1:")) << complaint(items[0], "x");
  EXPECT_TRUE(complaint(items[2], "x").starts_with("file1:2:")) << complaint(items[2], "x");
}

TEST(Layers, AValueThatIsReplacedLosesThePlacesWithinIt) {
  const auto whole =
      whole_of({R"({"a": {"x": {"p": 1}}})", R"({"a": {"x": {"p": 2}}})", "{\"a\":\n{\"x\": [1]}}"});
  auto a = json::ObjectReader(whole).object("a");
  EXPECT_EQ(a.place("x"), "file2:2");
  EXPECT_EQ(json::standing_of(whole, "/a/x/0").document->name, "file2");
}
