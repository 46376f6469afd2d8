// Known failures in configuration.json: reading, matching, writing.
#include "registry/expected.h"

#include "base/error.h"
#include "registry/configuration.h"

#include <gtest/gtest.h>

using namespace orbs;
using registry::ExpectedFailure;

namespace {

std::string configuration_text(const std::string& expected) {
  return R"({ "format":   "orbs-configuration/1",
  "suites": [ {"name": "s", "cases": "c", "references": "r"} ],
  "renderers": [
    { "name": "cycles", "executable": "a", "declares": "G1", "command": ["{executable}", "{scene}", "{output}"] } ])" +
         expected + "\n}\n";
}

std::vector<ExpectedFailure> read(const std::string& text) {
  return registry::parse_configuration("configuration.json", text).expected;
}

std::string message_of(const std::string& expected) {
  try {
    read(configuration_text(expected));
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

ExpectedFailure entry(const std::string& scene, const std::string& reason) {
  ExpectedFailure made;
  made.renderer = "cycles";
  made.scene = scene;
  made.verdict = "fail";
  made.reason = reason;
  made.measure = {{"psnr_srgb8", 30.5}, {"pixels [0,0,1,1]", std::nullopt}};
  return made;
}

bool matches(const std::string& range, const std::string& version) {
  return registry::is_in_range(registry::parse_version_range(range), version);
}

}  // namespace

TEST(VersionRange, ComparesTheFirstNumberOfTheText) {
  EXPECT_TRUE(matches("<4.0", "Blender 3.4.1"));
  EXPECT_FALSE(matches("<4.0", "Blender 4.0.0"));
  EXPECT_FALSE(matches("<4.0", "Blender 10.1"));
  EXPECT_TRUE(matches("=3.4", "3.4.0"));
  EXPECT_FALSE(matches("=3.4", "3.4.1"));
  EXPECT_TRUE(matches(">=3.4 <4", "v3.10"));
  EXPECT_FALSE(matches(">=3.4 <4", "3.3.9"));
  EXPECT_FALSE(matches(">0", "unknown"));
}

TEST(VersionRange, WhatIsNoComparisonIsRefused) {
  for (const char* text : {"", "4.0", "<", "<4.x", "< 4", "~4", "<4.0beta"})
    EXPECT_THROW(registry::parse_version_range(text), InputError) << text;
}

TEST(ExpectedFailures, TheLastEntryThatMatchesCounts) {
  const auto expected = read(configuration_text(R"(, "expected": [
    {"renderer": "c*", "scene": "*", "verdict": "fail", "reason": "all"},
    {"renderer": "cycles", "version": "<4.0", "scene": "101,1?3", "verdict": "crash", "reason": "some"} ])"));
  const auto reason = [&](const std::string& version, const std::string& scene) {
    const auto* found = registry::find_expected(expected, "cycles", version, scene);
    return found == nullptr ? "none" : found->reason;
  };
  EXPECT_EQ(reason("3.4", "123"), "some");
  EXPECT_EQ(reason("3.4", "201"), "all");
  EXPECT_EQ(reason("4.0", "101"), "all");
  EXPECT_EQ(registry::find_expected(expected, "pbrt", "3.4", "101"), nullptr);
}

TEST(ExpectedFailures, MistakesAreRefusedWithTheirPlace) {
  const auto unknown =
      message_of(R"(, "expected": [{"renderer": "cycle", "scene": "1", "verdict": "fail", "reason": "r"}])");
  EXPECT_NE(unknown.find("configuration.json:4:"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("no renderer matches 'cycle' (did you mean 'cycles'?)"), std::string::npos)
      << unknown;
  const auto version = message_of(
      R"(, "expected": [{"renderer": "cycles", "version": "4", "scene": "1", "verdict": "fail", "reason": "r"}])");
  EXPECT_NE(version.find("'4' is no comparison of a version"), std::string::npos) << version;
  EXPECT_NE(
      message_of(R"(, "expected": [{"renderer": "cycles", "scene": "1", "verdict": "fail", "reason": " "}])")
          .find("must say why"),
      std::string::npos);
}

TEST(ExpectedFailures, AreAddedWithEveryOtherByteAsItWas) {
  const auto before = configuration_text("");
  const auto once = registry::with_expected(before, {}, {entry("101", "first")});
  const auto end = before.rfind(']') + 1;
  EXPECT_EQ(once.substr(0, end), before.substr(0, end));
  EXPECT_EQ(once.substr(once.size() - 3), "\n}\n");
  const auto present = read(once);
  ASSERT_EQ(present.size(), 1U);
  EXPECT_EQ(present[0].measure, entry("", "").measure);
  const auto twice = registry::with_expected(once, present, {entry("102", "second"), entry("103", "third")});
  ASSERT_EQ(read(twice).size(), 3U);
  EXPECT_EQ(read(twice)[2].reason, "third");
}

TEST(ExpectedFailures, AnEntryOfTheSameSceneIsReplacedAndKeepsItsVersion) {
  const auto before = configuration_text(R"(, "expected": [
    {"renderer": "cycles", "version": "<4.0", "scene": "101", "verdict": "crash", "reason": "old"},
    {"renderer": "cycles",   "scene": "1*", "verdict": "fail", "reason": "pattern"} ])");
  const auto after = registry::with_expected(before, read(before), {entry("101", "new")});
  const auto expected = read(after);
  ASSERT_EQ(expected.size(), 2U);
  EXPECT_EQ(expected[0].reason, "new");
  EXPECT_EQ(expected[0].version.text, "<4.0");
  EXPECT_NE(after.find(R"({"renderer": "cycles",   "scene": "1*")"), std::string::npos);
}
