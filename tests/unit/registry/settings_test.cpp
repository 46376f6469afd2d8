// The settings of a run are listed once: what is written into a plan is what is read from it.
#include "json/document.h"
#include "json/field_reader.h"
#include "json/field_writer.h"
#include "registry/run_settings.h"

#include <string>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

// Gives every setting another value than it has.
struct Change {
  int count = 0;
  void operator()(const std::string& /*key*/, std::string& value, const json::Field& /*field*/) {
    value += "x";
    ++count;
  }
  void operator()(const std::string& /*key*/, int& value, const json::Field& /*field*/) {
    ++value;
    ++count;
  }
  void operator()(const std::string& /*key*/, double& value, const json::Field& /*field*/) {
    value /= 3;
    ++count;
  }
  void operator()(const std::string& /*key*/, bool& value, const json::Field& /*field*/) {
    value = !value;
    ++count;
  }
  void operator()(const std::string& /*key*/, registry::SizeDivisor& value, const json::Field& /*field*/) {
    value = registry::QuarterSize;
    ++count;
  }
};

struct Look {
  template <class T>
  void operator()(const std::string& key, const T& /*value*/, const json::Field& field) {
    EXPECT_FALSE(field.help.empty()) << key;
    EXPECT_NE(field.option.find("--"), std::string_view::npos) << key;
  }
};

/// Can stand for a member of any type.
struct Anything {
  template <class T>
  operator T() const;
};

/// How many members an aggregate has.
template <class T, class... Members>
constexpr int member_count() {
  if constexpr (requires { T{Members{}..., Anything{}}; })
    return member_count<T, Members..., Anything>();
  else
    return sizeof...(Members);
}

std::string text_of(const registry::RunSettings& settings) {
  json::Writer out;
  json::write_record(out, settings);
  return out.text();
}

}  // namespace

TEST(RunSettings, EachIsWrittenAndReadBack) {
  registry::RunSettings settings;
  Change change;
  fields(change, settings);
  EXPECT_EQ(change.count, member_count<registry::RunSettings>())
      << "a member that fields() does not list is no option, and a plan that is executed elsewhere lacks it";
  const auto text = text_of(settings);
  const auto document = json::parse("plan.json", text);
  EXPECT_EQ(text_of(json::read_settings<registry::RunSettings>(json::ObjectReader(document))), text);
  EXPECT_NE(text, text_of({}));
}

TEST(RunSettings, EachHasAHelpTextAndAnOption) {
  const registry::RunSettings settings;
  Look look;
  fields(look, settings);
}
