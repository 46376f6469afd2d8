// The TypeScript types of records, and enums in their files.
#include "json/page_types.h"

#include "base/error.h"
#include "json/document.h"
#include "json/field_reader.h"
#include "json/field_writer.h"

#include <gtest/gtest.h>

namespace orbs::json {

namespace {

enum class Mood { Good, Bad };

inline constexpr auto names(Mood) {
  return std::array{Named{Mood::Good, "good"}, Named{Mood::Bad, "not so good"}};
}

struct Inner {
  std::vector<double> column;
};

template <class Visitor, RecordOf<Inner> Record>
void fields(Visitor& visit, Record& inner) {
  visit("column", inner.column);
}

struct Outer {
  std::string name;
  Mood mood = Mood::Good;
  std::optional<int> maybe{};
  std::optional<Interval> interval{};
  std::vector<Inner> inner{};
  std::map<std::string, bool> flags{};
};

template <class Visitor, RecordOf<Outer> Record>
void fields(Visitor& visit, Record& outer) {
  visit.required("name", outer.name);
  visit("mood", outer.mood);
  visit("maybe", outer.maybe);
  visit.nullable("interval", outer.interval);
  visit("inner", outer.inner);
  visit("flags", outer.flags);
}

Mood read_mood(const std::string& text) {
  const auto document = json::parse("moods.json", R"({"mood": ")" + text + R"("})");
  json::ObjectReader in(document);
  FieldReader read(in);
  auto mood = Mood::Good;
  read("mood", mood);
  return mood;
}

}  // namespace

TEST(PageTypes, AreThoseOfTheMembersThatFieldsLists) {
  PageTypes types;
  EXPECT_EQ(types.add<Outer>(), "Outer");
  EXPECT_EQ(types.text(), R"(
export type Inner = {
  column: (number | null)[];
};

export type Interval = {
  value: number | null;
  low: number | null;
  high: number | null;
};

export type Outer = {
  name: string;
  mood: "good" | "not so good";
  maybe?: number;
  interval: Interval | null;
  inner: Inner[];
  flags: Record<string, boolean>;
};
)");
}

// The type says "| null" where null is written, and "?" where nothing is.
TEST(PageTypes, SayWhatTheWriterLeavesOut) {
  json::Writer out;
  write_record(out, Outer{.name = "n"});
  EXPECT_EQ(out.text(), R"({
  "name": "n",
  "mood": "good",
  "interval": null,
  "inner": [],
  "flags": {}
}
)");
}

TEST(Fields, AnEnumIsReadByItsNameAndOtherTextsAreRefusedWithTheNames) {
  EXPECT_EQ(read_mood("not so good"), Mood::Bad);
  try {
    read_mood("so so");
    FAIL() << "it was read";
  } catch (const InputError& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("moods.json:1:"), std::string::npos) << text;
    EXPECT_NE(text.find("expected one of 'good', 'not so good'"), std::string::npos) << text;
  }
}

}  // namespace orbs::json
