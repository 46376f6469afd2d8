// Known failures in configuration.json: reading, matching, writing.
#include "registry/expected.h"

#include "base/error.h"
#include "registry/configuration.h"
#include "registry/version_range.h"

#include <fmt/format.h>
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

const registry::RunKind kRun{"s", registry::FullSize, "2026-11-25"};

// The reasons of the entries that are found for cycles 3.4 and the scene 101: "counting/expired".
std::string reasons_of(const std::vector<ExpectedFailure>& expected, const registry::RunKind& run) {
  const auto found = registry::find_expected(expected, "cycles", "3.4", "101", run);
  const auto reason = [](const ExpectedFailure* entry) { return entry == nullptr ? "" : entry->reason; };
  return reason(found.counting) + "/" + reason(found.expired);
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
    const auto* found = registry::find_expected(expected, "cycles", version, scene, kRun).counting;
    return found == nullptr ? "none" : found->reason;
  };
  EXPECT_EQ(reason("3.4", "123"), "some");
  EXPECT_EQ(reason("3.4", "201"), "all");
  EXPECT_EQ(reason("4.0", "101"), "all");
  EXPECT_EQ(registry::find_expected(expected, "pbrt", "3.4", "101", kRun).counting, nullptr);
}

TEST(ExpectedFailures, AreOfTheirSuiteAndSize) {
  const auto expected = read(configuration_text(R"(, "expected": [
    {"renderer": "cycles", "scene": "101", "verdict": "fail", "reason": "any"},
    {"renderer": "cycles", "scene": "101", "suite": "s", "size": "1/4", "verdict": "fail", "reason": "small"} ])"));
  EXPECT_EQ(reasons_of(expected, {"s", registry::QuarterSize, "2026-11-25"}), "small/");
  EXPECT_EQ(reasons_of(expected, {"s", registry::FullSize, "2026-11-25"}), "any/");
  EXPECT_EQ(reasons_of(expected, {"other", registry::QuarterSize, "2026-11-25"}), "any/");
}

// On its last day an entry still counts; what it expires for is named, unless an earlier entry counts.
TEST(ExpectedFailures, ExpireAfterTheirLastDay) {
  const std::string entries = R"(
    {"renderer": "cycles", "scene": "101", "until": "2026-11-25", "verdict": "fail", "reason": "for now"} ])";
  const auto expected = read(configuration_text(R"(, "expected": [)" + entries));
  EXPECT_EQ(reasons_of(expected, {"s", registry::FullSize, "2026-11-25"}), "for now/");
  EXPECT_EQ(reasons_of(expected, {"s", registry::FullSize, "2026-11-26"}), "/for now");
  const auto two = read(configuration_text(
      R"(, "expected": [ {"renderer": "*", "scene": "*", "verdict": "fail", "reason": "always"}, )" +
      entries));
  EXPECT_EQ(reasons_of(two, {"s", registry::FullSize, "2026-11-26"}), "always/");
}

TEST(ExpectedFailures, ADayThatIsNoneIsRefused) {
  for (const char* day : {"2026-02-29", "2026-13-01", "26-11-25", "2026-11-25T00:00:00", "2026/11/25", ""})
    EXPECT_NE(
        message_of(fmt::format(R"(, "expected": [{{"renderer": "cycles", "scene": "1", "verdict": "fail", )"
                               R"("reason": "r", "until": "{}"}}])",
                               day))
            .find(fmt::format("'{}' is no day", day)),
        std::string::npos)
        << day;
  EXPECT_EQ(registry::parse_day("2028-02-29").text, "2028-02-29");
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
  EXPECT_NE(
      message_of(
          R"(, "expected": [{"renderer": "cycles", "scene": "1", "suite": "t", "verdict": "fail", "reason": "r"}])")
          .find("there is no suite 't'"),
      std::string::npos);
  EXPECT_NE(
      message_of(
          R"(, "expected": [{"renderer": "cycles", "scene": "1", "size": "1/3", "verdict": "fail", "reason": "r"}])")
          .find("/expected/0/size"),
      std::string::npos);
}

TEST(ExpectedFailures, AreAddedWithEveryOtherByteAsItWas) {
  const auto before = configuration_text("");
  const auto once = registry::with_expected(before, {}, {entry("101", "first")}, kRun.day);
  const auto end = before.rfind(']') + 1;
  EXPECT_EQ(once.substr(0, end), before.substr(0, end));
  EXPECT_EQ(once.substr(once.size() - 3), "\n}\n");
  const auto present = read(once);
  ASSERT_EQ(present.size(), 1U);
  EXPECT_EQ(present[0].measure, entry("", "").measure);
  const auto twice =
      registry::with_expected(once, present, {entry("102", "second"), entry("103", "third")}, kRun.day);
  ASSERT_EQ(read(twice).size(), 3U);
  EXPECT_EQ(read(twice)[2].reason, "third");
}

TEST(VersionRange, OfAVersionHoldsItAlone) {
  EXPECT_EQ(registry::range_of_version("Blender 3.4.1 (hash 0)").text, "=3.4.1");
  EXPECT_EQ(registry::range_of_version("POV-Ray 3.7.0.10.unofficial").text, "=3.7.0.10");
  EXPECT_EQ(registry::range_of_version("pbrt version 4 (built Nov 26)").text, "=4");
  EXPECT_EQ(registry::range_of_version("v1.2").text, "=1.2");
  for (const char* text : {"", "unknown", "commit 3f2a9", "commit a3f2"})
    EXPECT_TRUE(registry::is_absent(registry::range_of_version(text))) << text;
}

// With Blender 4.3 the numbers of 3.4 were overwritten, by an entry that did not hold for 4.3.
TEST(ExpectedFailures, AnEntryOfAnotherVersionIsAddedAndNotReplaced) {
  const auto before = configuration_text(R"(, "expected": [
    {"renderer": "cycles", "version": "<4.0", "scene": "101", "verdict": "fail", "reason": "of 3.4"} ])");
  auto added = entry("101", "of 4.3");
  added.version = registry::range_of_version("Blender 4.3.2");
  const auto expected = read(registry::with_expected(before, read(before), {added}, kRun.day));
  ASSERT_EQ(expected.size(), 2U);
  EXPECT_EQ(expected[0].reason, "of 3.4");
  EXPECT_EQ(expected[0].version.text, "<4.0");
  EXPECT_EQ(expected[1].version.text, "=4.3.2");
}

TEST(ExpectedFailures, AnEntryOfTheSameSceneIsReplacedAndKeepsItsVersion) {
  const auto before = configuration_text(R"(, "expected": [
    {"renderer": "cycles", "version": "<4.0", "scene": "101", "verdict": "crash", "reason": "old"},
    {"renderer": "cycles",   "scene": "1*", "verdict": "fail", "reason": "pattern"} ])");
  auto anew = entry("101", "new");
  anew.version = registry::range_of_version("Blender 3.4.1");
  const auto after = registry::with_expected(before, read(before), {anew}, kRun.day);
  const auto expected = read(after);
  ASSERT_EQ(expected.size(), 2U);
  EXPECT_EQ(expected[0].reason, "new");
  EXPECT_EQ(expected[0].version.text, "<4.0");
  EXPECT_NE(after.find(R"({"renderer": "cycles",   "scene": "1*")"), std::string::npos);
}

// So a failure at full size and the same one at a quarter of it stand beside each other.
TEST(ExpectedFailures, AnEntryOfAnotherSizeIsAddedAndNotReplaced) {
  const auto before = configuration_text(R"(, "expected": [
    {"renderer": "cycles", "scene": "101", "suite": "s", "size": "1/4", "verdict": "fail", "reason": "small"} ])");
  auto full = entry("101", "full");
  full.suite = "s";
  full.size = registry::FullSize;
  const auto expected = read(registry::with_expected(before, read(before), {full}, kRun.day));
  ASSERT_EQ(expected.size(), 2U);
  EXPECT_EQ(expected[0].size, registry::QuarterSize);
  EXPECT_EQ(expected[1].size, registry::FullSize);
  EXPECT_EQ(expected[1].suite, "s");
  EXPECT_EQ(expected[1].measure, full.measure);
}

TEST(ExpectedFailures, AReplacedEntryKeepsItsLastDayUnlessItHasPassed) {
  const auto before = configuration_text(R"(, "expected": [
    {"renderer": "cycles", "scene": "101", "until": "2026-11-25", "verdict": "fail", "reason": "old"} ])");
  const auto after = [&](const std::string& day) {
    return read(registry::with_expected(before, read(before), {entry("101", "new")}, day)).at(0);
  };
  EXPECT_EQ(after("2026-11-25").until.value_or(registry::Day{"none"}).text, "2026-11-25");
  EXPECT_FALSE(after("2026-11-26").until.has_value());
  EXPECT_EQ(after("2026-11-26").reason, "new");
  auto dated = entry("101", "new");
  dated.until = registry::Day{"2027-01-02"};
  const auto replaced = read(registry::with_expected(before, read(before), {dated}, "2026-11-25"));
  EXPECT_EQ(replaced.at(0).until.value_or(registry::Day{"none"}).text, "2027-01-02") << "its own comes first";
}
