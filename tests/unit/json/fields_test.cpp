// Settings and records: what fields() lists is written, read back, and refused where it is wrong.
#include "json/fields.h"

#include "json/document.h"
#include "json/field_reader.h"
#include "json/field_writer.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace made_up {

using namespace orbs;

enum class Colour { Red, Green };

std::string to_text(Colour colour) { return colour == Colour::Red ? "red" : "green"; }

void from_text(std::string_view text, Colour& colour) {
  if (text != "red" && text != "green") throw InputError("'" + std::string(text) + "' is no colour");
  colour = text == "red" ? Colour::Red : Colour::Green;
}

struct Wheel {
  int spokes = 3;
  friend bool operator==(const Wheel&, const Wheel&) = default;
};

template <class Visitor, json::RecordOf<Wheel> Record>
void fields(Visitor& visit, Record& wheel) {
  visit("spokes", wheel.spokes, {.range = {1, 9}});
}

struct Cart {
  std::string name;
  Colour colour = Colour::Red;
  double load_kg = 5;
  std::optional<double> limit_kg{};
  bool is_old = false;
  std::vector<Wheel> wheels{};
  std::map<std::string, std::optional<double>> marks{};
  std::map<Colour, std::string> words{};
  friend bool operator==(const Cart&, const Cart&) = default;
};

template <class Visitor, json::RecordOf<Cart> Record>
void fields(Visitor& visit, Record& cart) {
  visit.required("name", cart.name, {.changes_image = false});
  visit("colour", cart.colour);
  visit("load_kg", cart.load_kg, {.range = {1, 100}, .advice = "or it is empty"});
  visit("limit_kg", cart.limit_kg, {.range = json::kPositive});
  visit("is_old", cart.is_old);
  visit("wheels", cart.wheels, {.changes_image = false});
  visit("marks", cart.marks);
  visit("words", cart.words);
}

Cart read(const std::string& text) {
  const auto document = json::parse("cart.json", text);
  return json::read_settings<Cart>(json::ObjectReader(document));
}

// The first line of the complaint, behind the place in the file.
std::string complaint_about(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& e) {
    const std::string what = e.what();
    const auto begin = what.find(": ") + 2;
    return what.substr(begin, what.find('\n') - begin);
  }
  return "none";
}

std::string text_of(const Cart& cart, json::FieldWriter::Filter keeps = nullptr) {
  json::Writer out;
  out.begin_object();
  json::write_fields(out, cart, keeps);
  return out.end_object().text();
}

}  // namespace made_up

using namespace made_up;

TEST(Fields, WhatIsWrittenIsReadBack) {
  const Cart cart{
      "a", Colour::Green, 7, 20, true, {{4}, {5}}, {{"x", 1}, {"y", {}}}, {{Colour::Green, "go"}}};
  EXPECT_EQ(read(text_of(cart)), cart) << text_of(cart);
}

TEST(Fields, WhatIsMissingKeepsItsDefault) { EXPECT_EQ(read(R"({"name": "a"})"), Cart{"a"}); }

TEST(Fields, ComplaintsNameTheKeyAndWhatIsExpected) {
  EXPECT_EQ(complaint_about("{}"), "/: key 'name' is missing");
  EXPECT_EQ(complaint_about(R"({"name": "a", "color": "red"})"),
            "/color: unknown key (did you mean 'colour'?)");
  EXPECT_EQ(complaint_about(R"({"name": "a", "colour": "blue"})"), "/colour: 'blue' is no colour");
  EXPECT_EQ(complaint_about(R"({"name": "a", "load_kg": 0.5})"),
            "/load_kg: must be at least 1, or it is empty");
  EXPECT_EQ(complaint_about(R"({"name": "a", "load_kg": 500})"), "/load_kg: must lie in [1, 100], is 500");
  EXPECT_EQ(complaint_about(R"({"name": "a", "limit_kg": null})"), "/limit_kg: must be a number, is null");
  EXPECT_EQ(complaint_about(R"({"name": "a", "wheels": [{}, {"spokes": 2.5}]})"),
            "/wheels/1/spokes: must be a whole number, is 2.5");
  EXPECT_EQ(complaint_about(R"({"name": "a", "wheels": [{"spoke": 2}]})"),
            "/wheels/0/spoke: unknown key (did you mean 'spokes'?)");
  EXPECT_EQ(complaint_about(R"({"name": "a", "words": {"blue": "b"}})"), "/words/blue: 'blue' is no colour");
  EXPECT_EQ(complaint_about(R"({"name": "a\u0000"})").substr(0, 30), "/name: must not hold a zero by");
}

// A file of a run may be of a newer program, and null is a number that JSON cannot hold.
TEST(Fields, ARecordIgnoresWhatItDoesNotKnow) {
  const auto document =
      json::parse("cart.json", R"({"name": "a", "new": 1, "limit_kg": null, "wheels": [{"b": 1}]})");
  json::ObjectReader in(document);
  json::FieldReader visit(in);
  Cart cart;
  fields(visit, cart);
  EXPECT_EQ(cart, (Cart{.name = "a", .wheels = {{}}}));
}

TEST(Fields, AFilterChoosesWhatIsWritten) {
  const auto text =
      text_of({.name = "a", .wheels = {{}}}, [](const json::Field& field) { return field.changes_image; });
  EXPECT_EQ(text.find("name"), std::string::npos) << text;
  EXPECT_EQ(text.find("wheels"), std::string::npos) << text;
  EXPECT_NE(text.find("load_kg"), std::string::npos) << text;
}
