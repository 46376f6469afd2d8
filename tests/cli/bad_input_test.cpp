// A tour of what a user can get wrong: status 2, one line that says what is wrong, and nothing left behind.
#include "cli/sandbox.h"

#include <ostream>

#include <gtest/gtest.h>

using orbs::cli_tests::Answer;
using orbs::cli_tests::configuration_with;
using orbs::cli_tests::Sandbox;

namespace {

struct Mistake {
  const char* name;
  std::vector<std::string> arguments;
  const char* complaint;
};

class BadArguments : public testing::TestWithParam<Mistake> {};

void expect_refusal(const Sandbox& sandbox, const Answer& answer, const std::string& complaint) {
  EXPECT_EQ(answer.status, 2) << answer.text;
  EXPECT_TRUE(answer.text.starts_with("orbs: ")) << answer.text;
  EXPECT_NE(answer.text.find(complaint), std::string::npos) << answer.text;
  EXPECT_TRUE(sandbox.runs().empty());
  EXPECT_FALSE(sandbox.has("out"));
}

}  // namespace

TEST_P(BadArguments, AreRefusedBeforeAnythingIsCreated) {
  const Sandbox sandbox;
  expect_refusal(sandbox, sandbox.orbs(GetParam().arguments), GetParam().complaint);
}

INSTANTIATE_TEST_SUITE_P(
    Mistakes,
    BadArguments,
    testing::Values(
        Mistake{"unknown_scene",
                {"run", "-r", "good", "-s", "gray", "-o", "out"},
                "no scene matches 'gray' (did you mean 'grey'?)"},
        Mistake{"unknown_case",
                {"run", "-r", "good", "-c", "m1_gray"},
                "no case matches 'm1_gray' (did you mean 'm1_grey'?)"},
        Mistake{"unknown_requirement",
                {"run", "-r", "good", "--requirement", "M2"},
                "no requirement matches 'M2'"},
        Mistake{"unknown_renderer", {"run", "-r", "god"}, "no renderer matches 'god' (did you mean 'good'?)"},
        Mistake{"filters_that_meet_nowhere",
                {"run", "-r", "good", "-s", "mirror", "-c", "m1_grey"},
                "no scene is left"},
        Mistake{"unknown_suite", {"run", "--suite", "orps"}, "has no suite 'orps'"},
        Mistake{"unknown_option", {"run", "--renderers", "good"}, "--renderers"},
        Mistake{"unknown_command", {"rum"}, "there is no command 'rum' (did you mean 'run'?)"},
        Mistake{"no_command", {}, "'orbs' needs a command; there are run, merge, "},
        Mistake{"no_inner_command", {"renderer"}, "'orbs renderer' needs a command; there is add"},
        Mistake{"nearest_option",
                {"run", "--rendrer", "good"},
                "'orbs run' has no option --rendrer (did you mean '--renderer'?)"},
        Mistake{"surplus_word", {"run", "good"}, "'orbs run' takes no further argument 'good'"},
        Mistake{"no_value", {"run", "-r"}, "--renderer: needs a value"},
        Mistake{"no_integer", {"run", "-j", "1.5"}, "--jobs: expected a number from 1 to 1024, not '1.5'"},
        Mistake{"out_of_range", {"run", "-j", "0"}, "--jobs: expected a number from 1 to 1024, not '0'"},
        Mistake{
            "not_in_list",
            {"list", "scene"},
            "what: expected one of all, suites, renderers, requirements, cases, scenes, not 'scene' (did you mean 'scenes'?)"},
        Mistake{"budget_without_unit",
                {"cost", "--time", "20min"},
                "--time: '20min' is no number above 0 with one of the units s, m, h"},
        Mistake{"run_budget",
                {"run", "--target-budget", "5min"},
                "--target-budget: '5min' is no number above 0 with one of the units s, m, h"},
        Mistake{"budget_infinite", {"cost", "--time", "inf"}, "--time: 'inf' is no number"},
        Mistake{"judged_folder_is_empty", {"judge", ""}, "folder: needs a folder"},
        Mistake{"merged_folder_is_empty", {"merge", ""}, "runs: needs a folder"},
        Mistake{"compared_run_is_empty", {"compare-runs", "", "a"}, "before: needs a folder"},
        Mistake{"report_of_nothing", {"report", "", "-o", "x.html"}, "run: needs a folder"},
        Mistake{"report_room",
                {"report", "-o", "x.html", "--most-megabytes", "1e300"},
                "--most-megabytes: expected a number from 0 to"},
        Mistake{"no_number", {"run", "-j", "many"}, "many"},
        Mistake{"no_jobs", {"run", "-j", "0"}, "0"},
        Mistake{"negative_seed", {"run", "--seed", "-1"}, "--seed: expected 0 or more, not '-1'"},
        Mistake{"no_samples", {"run", "--spp-scale", "0"}, "--spp-scale: expected a number above 0, not '0'"},
        Mistake{
            "samples_are_no_number", {"run", "--spp-scale", "nan"}, "expected a number above 0, not 'nan'"},
        Mistake{"resumed_folder_is_empty", {"run", "--resume", ""}, "--resume: needs a folder"},
        Mistake{"output_is_empty", {"run", "-o", ""}, "--output: needs a folder"},
        Mistake{"configuration_is_empty", {"run", "--configuration", ""}, "--configuration: needs a file"},
        Mistake{"report_output_is_empty", {"report", "-o", ""}, "--output: needs a file"},
        Mistake{"tolerance_is_no_number",
                {"compare", "a.exr", "b.exr", "--min", "nan"},
                "expected a number, not 'nan'"},
        Mistake{"help_of_the_command",
                {"report"},
                "--output is required; 'orbs report --help' lists the options"},
        Mistake{"served_folder_is_missing", {"serve", "none"}, "none: holds no results.json"},
        Mistake{
            "qualified_folder_is_missing", {"qualify", "none", "-r", "good"}, "none: holds no results.json"},
        Mistake{"missing_value", {"run", "-r"}, "--renderer"},
        Mistake{"named_renderer_is_missing", {"run", "-r", "absent"}, "'/nowhere/at/all' was not found"},
        Mistake{"exec_is_not_there",
                {"run", "-r", "good", "-e", "./nothing", "-o", "out"},
                "'./nothing' was not found"},
        Mistake{"exec_is_a_folder", {"run", "-r", "good", "-e", "./cases"}, "'./cases' was not found"},
        Mistake{"exec_cannot_be_executed",
                {"run", "-r", "good", "-e", "./configuration.json"},
                "may not be executed; chmod +x ./configuration.json permits it"},
        Mistake{"exec_of_several",
                {"run", "-r", "good,dark", "-e", "/bin/true"},
                "-e/--exec is the program of one renderer, but 2 are chosen"},
        Mistake{"output_is_taken", {"run", "-r", "good", "-o", "cases"}, "exists already"},
        Mistake{"configuration_is_missing",
                {"run", "--configuration", "none.json"},
                "none.json: cannot be read"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

TEST(BadFiles, ConfigurationErrorsNameFileLineAndColumn) {
  const Sandbox sandbox;
  sandbox.write("configuration.json",
                "{\n  \"format\": \"orbs-configuration/1\", \"stands_alone\": true,\n  \"renderer\": []\n}");
  expect_refusal(sandbox, sandbox.orbs({"run"}), "configuration.json:1:1: /: key 'suites' is missing");
  sandbox.write("configuration.json", "{\n  \"format\" \"orbs-configuration/1\"}");
  expect_refusal(sandbox, sandbox.orbs({"run"}), "configuration.json:2:33: not valid JSON");
}

TEST(BadFiles, ABrokenSceneStopsTheRunBeforeItBegins) {
  const Sandbox sandbox;
  sandbox.write("cases/m3_mirror/mirror.json", R"({"format": "orbs-scene/1", "nam": "s"})");
  const auto answer = sandbox.orbs({"run", "-r", "good"});
  expect_refusal(sandbox, answer, "mirror.json");
  EXPECT_NE(answer.text.find("while reading scene 'mirror'"), std::string::npos) << answer.text;
}

TEST(BadFiles, AnUnknownMetricOfAGateIsFoundAtOnce) {
  const Sandbox sandbox;
  auto text = sandbox.read("cases/m1_grey/case.json");
  text.insert(text.rfind('}'), R"(, "gates": [{"metric": "psnr_srgb", "min": 3, "reason": "r"}])");
  sandbox.write("cases/m1_grey/case.json", text);
  const auto answer = sandbox.orbs({"run", "-r", "good"});
  expect_refusal(sandbox, answer, "there is no metric 'psnr_srgb' (did you mean 'psnr_srgb8'?)");
  EXPECT_NE(answer.text.find("m1_grey/case.json:1"), std::string::npos) << answer.text;
}

TEST(BadFiles, ARectangleBeyondTheImageIsFoundAtOnce) {
  const Sandbox sandbox;
  auto text = sandbox.read("cases/m1_grey/case.json");
  text.insert(text.rfind('}'),
              R"(, "masks": [{"scene": "grey", "rectangles": [[0,0,13,8]], "reason": "r"}])");
  sandbox.write("cases/m1_grey/case.json", text);
  expect_refusal(sandbox, sandbox.orbs({"run", "-r", "good"}),
                 "the rectangle [0,0,13,8] of 'grey' reaches beyond its 12 x 8 pixels");
}

TEST(BadFiles, AMaskOverTheWholeImageIsFoundAtOnce) {
  const Sandbox sandbox;
  auto text = sandbox.read("cases/m1_grey/case.json");
  text.insert(text.rfind('}'),
              R"(, "masks": [{"scene": "grey", "rectangles": [[0,0,12,8]], "reason": "r"}])");
  sandbox.write("cases/m1_grey/case.json", text);
  expect_refusal(sandbox, sandbox.orbs({"run", "-r", "good"}), "while reading the masks of 'grey'");
}

TEST(Defaults, OfTheConfigurationHoldUntilTheCommandLineOverridesThem) {
  const Sandbox sandbox;
  sandbox.write(
      "configuration.json",
      configuration_with(R"("renderer": "good", "scene": "grey", "log": false, "dry_run": true, "seed": 5)"));
  const auto dry = sandbox.orbs({"run"});
  EXPECT_EQ(dry.status, 0);
  EXPECT_NE(dry.text.find("--seed 5"), std::string::npos) << dry.text;
  EXPECT_TRUE(sandbox.runs().empty());
  EXPECT_EQ(sandbox.orbs({"run", "--no-dry-run", "-o", "a"}).status, 0);
  EXPECT_FALSE(sandbox.has("a/good/grey/log.txt"));
  EXPECT_FALSE(sandbox.has("a/good/mirror"));
  EXPECT_EQ(sandbox.orbs({"run", "--no-dry-run", "--log", "-o", "b"}).status, 0);
  EXPECT_TRUE(sandbox.has("b/good/grey/log.txt"));
}

TEST(Defaults, ALogIsKeptWhereSomethingWentWrongEvenWithoutLogs) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "exit3", "-s", "grey", "--no-log", "-o", "out"});
  EXPECT_TRUE(sandbox.has("out/exit3/grey/log.txt"));
}
