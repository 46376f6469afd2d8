// orbs cost works from the command line to its files; what its numbers are is for the unit tests.
#include "cli/sandbox.h"
#include "studies/cost/json.h"

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::contains;
using cli_tests::replace_in;
using cli_tests::Sandbox;

namespace {

studies::CostRecord record_of(const Sandbox& sandbox, const std::string& folder) {
  return studies::read_cost_file(sandbox.folder() / folder / "cost.json");
}

std::vector<std::string> cost(const std::vector<std::string>& more) {
  std::vector<std::string> words{"cost", "-r", "good", "-s", "grey"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace

TEST(Cost, RendersEverySeedOfEverySettingAndTheFixedCost) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs(cost({"--sweep", "2,8", "--seeds", "3", "-o", "c"}));
  ASSERT_EQ(answer.status, 0) << answer.text;
  const auto record = record_of(sandbox, "c");
  EXPECT_TRUE(record.is_finished);
  ASSERT_EQ(record.sweeps.size(), 1);
  ASSERT_EQ(record.sweeps[0].settings.size(), 2);
  EXPECT_EQ(record.sweeps[0].is_noise_free, false);
  using studies::Purpose;
  std::map<std::pair<Purpose, std::string>, int> counts;
  for (const auto& render : record.renders) ++counts[{render.purpose, render.setting}];
  const decltype(counts) expected{{{Purpose::FixedCost, ""}, 3},
                                  {{Purpose::Sweep, "2 spp"}, 3},
                                  {{Purpose::Sweep, "8 spp"}, 3},
                                  {{Purpose::Again, "8 spp"}, 3}};
  EXPECT_EQ(counts, expected);
  for (const char* file :
       {"c/cost.csv", "c/images/good/grey/1.png", "c/images/good/grey/1.exr", "c/images/reference/grey.exr"})
    EXPECT_TRUE(sandbox.has(file)) << file;
  const auto shown = sandbox.orbs({"cost", "--show", "c", "--markdown"});
  EXPECT_EQ(shown.status, 0) << shown.text;
  EXPECT_TRUE(contains(shown.text, "|  | CPU time to 35 dB | good |")) << shown.text;
}

TEST(Cost, GoesOnWhereItWasInterrupted) {
  const Sandbox sandbox;
  ASSERT_EQ(sandbox.orbs(cost({"--sweep", "2,8", "--seeds", "3", "-o", "c"})).status, 0);
  auto record = record_of(sandbox, "c");
  const auto all = record.renders.size();
  const auto kept = record.renders.at(2);
  record.renders.resize(3);
  for (auto& render : record.renders) render.other_share = 0;  // or those beside other work are made again
  sandbox.write("c/cost.json", studies::cost_json(record));
  const auto answer = sandbox.orbs(cost({"--sweep", "2,8", "--seeds", "3", "--resume", "c"}));
  ASSERT_EQ(answer.status, 0) << answer.text;
  record = record_of(sandbox, "c");
  EXPECT_EQ(record.renders.size(), all);
  EXPECT_EQ(record.renders.at(2).cpu_seconds, kept.cpu_seconds) << "rendered once more";
}

TEST(Cost, RefusesToGoOnOnAnotherMachine) {
  const Sandbox sandbox;
  ASSERT_EQ(sandbox.orbs(cost({"--sweep", "2", "--seeds", "2", "-o", "c"})).status, 0);
  auto record = record_of(sandbox, "c");
  record.host.cpu = "another processor";
  sandbox.write("c/cost.json", studies::cost_json(record));
  const auto answer = sandbox.orbs(cost({"--sweep", "2", "--seeds", "2", "--resume", "c"}));
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "was measured on another machine")) << answer.text;
}

TEST(Cost, SweepsTheSettingsThatTheConfigurationLists) {
  const Sandbox sandbox;
  sandbox.add_to_good(R"(, "cost_sweep": [{"name": "coarse", "spp": 3}, {"name": "fine", "spp": 9}])");
  const auto answer = sandbox.orbs(cost({"--seeds", "2", "-o", "c"}));
  ASSERT_EQ(answer.status, 0) << answer.text;
  const auto record = record_of(sandbox, "c");
  EXPECT_EQ(record.renderers.at(0).sweep, studies::SweepOf::Settings);
  ASSERT_EQ(record.sweeps.at(0).settings.size(), 2);
  EXPECT_EQ(record.sweeps[0].settings[1].name, "fine");
  EXPECT_EQ(record.sweeps[0].settings[1].spp, 9);
}

TEST(Cost, ARendererThatFailsEndsItsCurveWithTheReason) {
  const Sandbox sandbox;
  const auto answer =
      sandbox.orbs({"cost", "-r", "good,exit3", "-s", "grey", "--sweep", "2", "--seeds", "2", "-o", "c"});
  ASSERT_EQ(answer.status, 0) << answer.text;
  const auto record = record_of(sandbox, "c");
  ASSERT_EQ(record.sweeps.size(), 2);
  EXPECT_TRUE(contains(record.sweeps[1].note, "exit")) << record.sweeps[1].note;
}

// Scene 101 belongs to M1; G1, G2 and others look at it too.
TEST(Cost, ASceneIsKnownByTheCaseThatItBelongsTo) {
  const Sandbox sandbox;
  const auto answer =
      sandbox.orbs({"cost", "--configuration", ORBS_SOURCE_DIR "/configuration.json", "-r", "orbs", "-s",
                    "101", "--sweep", "1", "--seeds", "2", "--size", "1/8", "-o", "c"});
  ASSERT_EQ(answer.status, 0) << answer.text;
  ASSERT_EQ(record_of(sandbox, "c").targets.size(), 1);
  EXPECT_EQ(record_of(sandbox, "c").targets[0].requirement, "M1");
}

TEST(Cost, RefusesABudgetWithoutANumber) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs(cost({"--time", "soon", "-o", "c"}));
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "'soon' is no number above 0 with one of the units s, m, h"))
      << answer.text;
  EXPECT_FALSE(sandbox.has("c"));
}

TEST(Cost, ASpentBudgetEndsTheStudyAndWhatIsMissingIsNamed) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs(cost({"--sweep", "2,8", "--seeds", "3", "--time", "0.001s", "-o", "c"}));
  ASSERT_EQ(answer.status, 0) << answer.text;
  const auto record = record_of(sandbox, "c");
  EXPECT_TRUE(record.is_finished);
  EXPECT_TRUE(record.renders.empty());
  EXPECT_TRUE(contains(answer.text, "good on grey: not measured: 2 spp, 8 spp")) << answer.text;
}

TEST(Cost, AStudyOfAnEarlierVersionIsShown) {
  const Sandbox sandbox;
  const auto answer =
      sandbox.orbs({"cost", "--show", ORBS_SOURCE_DIR "/tests/data/cost-2.json", "--markdown"});
  ASSERT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "orbs twice on 1 scene:")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "other work on the machine: not measured")) << answer.text;
  EXPECT_FALSE(contains(answer.text, "seeds of")) << "of a study that had all the time that it wanted";
}

// The fake starts in 0.05 s and takes 0.02 s for each sample of each image, and the last image of a process
// counts.
TEST(Cost, OfASequenceOfImagesTheTimeOfOneCounts) {
  const Sandbox sandbox;
  replace_in(sandbox, "configuration.json", R"("renderers": [)", R"("renderers": [{"name": "sequence",
  "executable": "{build}/orbs-fake-renderer", "declares": "G5/M8",
  "image_sequence": {"words": ["--image", "0"], "suffix": "_last"},
  "command": ["{executable}", "--mode", "sequence", "--output", "{output}", "--scene", "{scene}", "--width", "{width}",
              "--height", "{height}", "--grey", "0.5", "--spp", "{spp}", "{images}"]},)");
  const auto answer =
      sandbox.orbs({"cost", "-r", "sequence", "-s", "grey", "--sweep", "2,4", "--seeds", "2", "-o", "c"});
  ASSERT_EQ(answer.status, 0) << answer.text;
  auto record = record_of(sandbox, "c");
  ASSERT_EQ(record.renderers.at(0).sequence_images, 1);
  for (auto& render : record.renders) {
    render.other_share = 0;  // or those beside other work are left out
    const bool is_fixed = render.purpose == studies::Purpose::FixedCost;
    EXPECT_EQ(render.images, is_fixed ? 1 : render.seed);
    if (is_fixed) continue;
    EXPECT_GE(render.images, 4) << "the first three have samples of the pilot or of the setting before";
    EXPECT_GE(render.cpu_seconds, 0.05 + render.images * 0.02 * render.spp);
  }
  const auto numbers = studies::cost_numbers(record);
  const auto& curve = numbers.curves.at(0);
  ASSERT_TRUE(curve.fixed_cpu_seconds);
  EXPECT_NEAR(curve.fixed_cpu_seconds->value, 0.1, 0.05);
  ASSERT_EQ(curve.points.size(), 2);
  for (const auto& point : curve.points)
    EXPECT_NEAR(point.cpu_seconds.value - curve.fixed_cpu_seconds->value, 0.02 * point.setting.spp, 0.03);
  ASSERT_TRUE(numbers.self_comparison);
}

TEST(Cost, StartTrialsAndOwnTimeOfARenderAreApart) {
  const Sandbox sandbox;
  sandbox.add_to_good(
      R"x(, "trial_seconds": {"pattern": "^fake: render_seconds 0.2(5)", "unit_seconds": 0.01})x");
  const auto answer = sandbox.orbs(cost({"--sweep", "2", "--seeds", "2", "-o", "c"}));
  ASSERT_EQ(answer.status, 0) << answer.text;
  for (const auto& render : record_of(sandbox, "c").renders) {
    EXPECT_EQ(render.trial_seconds, 0.05);
    EXPECT_EQ(render.render_seconds, 0.25);
  }
  EXPECT_TRUE(contains(answer.text, "start (CPU)")) << answer.text;
}

TEST(Cost, TheReportOfAStudyWithoutImagesIsShortAndNeedsAFile) {
  const Sandbox sandbox;
  ASSERT_EQ(sandbox.orbs(cost({"--sweep", "2,4,8,16", "--seeds", "2", "-o", "c"})).status, 0);
  std::filesystem::remove_all(sandbox.folder() / "c/images");
  const auto folder = sandbox.orbs({"report", "c", "-o", "c"});
  EXPECT_EQ(folder.status, 2);
  EXPECT_TRUE(contains(folder.text, "-o c: this is a folder, and a report is one file: -o c/report.html"))
      << folder.text;
  const auto answer = sandbox.orbs({"report", "c", "-o", "page.html"});
  ASSERT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "images are not in it")) << answer.text;
  EXPECT_LE(std::count(answer.text.begin(), answer.text.end(), '\n'), 10) << answer.text;
}
