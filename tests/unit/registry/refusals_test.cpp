// Entries that would be found out only after hours, or never: each is refused with its place.
#include "base/error.h"
#include "registry/configuration.h"
#include "registry/plain_name.h"

#include <gtest/gtest.h>

using orbs::registry::parse_configuration;

namespace {

std::string refusal(const std::string& name,
                    const std::string& declares,
                    const std::string& command,
                    const std::string& more = "") {
  try {
    parse_configuration("configuration.json",
                        R"({"format": "orbs-configuration/1", "suites": [], "renderers": [
{"name": ")" + name + R"(", "executable": "a", "declares": ")" +
                            declares + R"(", "command": [)" + command + "]" + more + "}]}");
  } catch (const orbs::InputError& e) {
    return e.what();
  }
  return "no error";
}

constexpr const char* kCommand = R"("{executable}", "{scene}", "{output}")";

std::string name_refusal(const std::string& name) { return refusal(name, "G1", kCommand); }
std::string limit_refusal(const std::string& limits) {
  return refusal("a", "G1", kCommand, R"(, "limits": {)" + limits + "}");
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

}  // namespace

TEST(PlainName, BeginsWithALetterOrADigitAndHoldsNothingThatMeansSomethingElsewhere) {
  for (const char* right : {"orbs", "9", "v1.5", "a-b_c", "SF10", "jun"})
    EXPECT_EQ(name_refusal(right), "no error");
  for (const char* wrong : {"<b>", "a:b", "$HOME", "~", "-x", "_x", "a&b", "a'b", "a b", "\u00e9", ".x"}) {
    const auto message = name_refusal(wrong);
    expect_part(message, "configuration.json:2:");
    expect_part(message, std::string("/renderers/0/name: '") + wrong + "' is no name: ");
    expect_part(message, "begin with a letter or a digit, then use letters, digits, '-', '_' and '.'");
  }
}

TEST(PlainName, IsNoLongerThanAFileSystemTakesWithWhatOrbsAppends) {
  EXPECT_EQ(name_refusal(std::string(100, 'a')), "no error");
  expect_part(name_refusal(std::string(101, 'a')),
              "/renderers/0/name: has 101 characters, at most 100 are allowed");
}

TEST(PlainName, IsNoneOfThoseThatOrbsUsesInAFolderOfARun) {
  for (const char* taken :
       {"junit.xml", "plan.json", "results.csv", "results.json", "run.json", "run.lock", "references"})
    expect_part(name_refusal(taken),
                std::string("/renderers/0/name: '") + taken + "' is what orbs itself calls");
}

TEST(Declares, LevelsThatNoSuiteHasAreRefusedWithTheRange) {
  EXPECT_EQ(refusal("a", "G5/M8/L4/A4/E6", kCommand), "no error");
  EXPECT_EQ(refusal("a", "G0/E0+(6)", kCommand), "no error");
  for (const char* wrong : {"G9/M8", "G5/M99", "G5/X1", "G5/M8+(11)", "S8", "X0"}) {
    const auto message = refusal("a", wrong, kCommand);
    expect_part(message, "configuration.json:2:");
    expect_part(message, "/renderers/0/declares: there is no requirement ");
    expect_part(
        message,
        "; there are G1 to G5, M1 to M8, L1 to L4, A1 to A4, B1 to B9, C1 to C5, D1 to D6, E1 to E6, N1 to N6, V1, S1 to S7, T1 to T3, I1 to I2");
  }
  expect_part(refusal("a", "G1", kCommand, R"(, "known_limits": [{"requirements": ["M11"], "reason": "r"}])"),
              "/renderers/0/known_limits/0/requirements/0: there is no requirement M11");
}

TEST(Command, BeginsWithAProgram) {
  EXPECT_EQ(refusal("a", "G1", R"("/bin/sh", "-c", "{scene}", "{output}")"), "no error");
  for (const char* wrong : {R"("-c", "{scene}", "{output}")", R"("", "{scene}", "{output}")"})
    expect_part(refusal("a", "G1", wrong), "/renderers/0/command/0: must be a program or {executable}, is '");
}

TEST(Limits, ThatEveryRenderBreaksAreRefused) {
  EXPECT_EQ(limit_refusal(
                R"("wall_seconds": 0.01, "cpu_seconds": 0.01, "memory_megabytes": 1, "output_megabytes": 1)"),
            "no error");
  for (const char* key : {"memory_megabytes", "output_megabytes"})
    for (const char* few : {"0", "1e-9"})
      expect_part(limit_refusal(std::string("\"") + key + "\": " + few),
                  std::string("/renderers/0/limits/") + key +
                      ": must be at least 1, or no render ends well; leave it out for that of all renderers");
  for (const char* key : {"wall_seconds", "cpu_seconds"})
    expect_part(
        limit_refusal(std::string("\"") + key + "\": 1e-300"),
        std::string("/renderers/0/limits/") + key + ": must be at least 0.01, or no render ends well");
}
