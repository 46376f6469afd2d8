// orbs stability works from the command line to its files; what its numbers are is for the unit tests.
#include "cli/sandbox.h"
#include "studies/stability/json.h"

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::contains;
using cli_tests::Sandbox;

namespace {

studies::StabilityRecord record_of(const Sandbox& sandbox, const std::string& folder) {
  return studies::read_stability_file(sandbox.folder() / folder / "stability.json");
}

std::vector<std::string> stability(const std::vector<std::string>& more) {
  std::vector<std::string> words{"stability", "-r", "good", "-s", "grey"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace

TEST(Stability, ARendererThatFollowsPasses) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs(stability({"--relation", "translate_matrix,rotate", "-o", "s"}));
  ASSERT_EQ(answer.status, 0) << answer.text;
  const auto record = record_of(sandbox, "s");
  EXPECT_TRUE(record.is_finished);
  EXPECT_EQ(record.steps.size(), 10);
  EXPECT_TRUE(contains(answer.text, "all, to 1e+09 m, to the bit")) << answer.text;
}

// The fake renderer's image is the same whatever the scene emits.
TEST(Stability, ABreakEndsItsSweepAndIsShown) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs(stability({"--relation", "emission_up", "-o", "s"}));
  EXPECT_EQ(answer.status, 1) << answer.text;
  const auto record = record_of(sandbox, "s");
  ASSERT_EQ(record.steps.size(), 2) << "two breaks in a row end it";
  EXPECT_EQ(record.steps[0].outcome, studies::StepOutcome::Breaks);
  EXPECT_NEAR(record.steps[0].mean, 1.0 / 1024 - 1, 1e-6);
  for (const char* image : {"original.png", "changed.png", "difference.png"})
    EXPECT_TRUE(sandbox.has("s/" + record.steps[0].images + "/" + image)) << image;
  EXPECT_TRUE(sandbox.has("s/scenes/good/grey/emission_up-1024/changed/scene.json"));
  const auto shown = sandbox.orbs({"stability", "--show", "s", "--markdown"});
  EXPECT_EQ(shown.status, 1);
  EXPECT_TRUE(contains(shown.text, "| breaks at 2^10 |")) << shown.text;
}

TEST(Stability, PrecisionIsForEntriesThatNameItsArguments) {
  const Sandbox sandbox;
  sandbox.orbs(stability({"--relation", "precision", "-o", "s"}));
  const auto record = record_of(sandbox, "s");
  ASSERT_EQ(record.steps.size(), 1);
  EXPECT_EQ(record.steps[0].outcome, studies::StepOutcome::NotApplicable);
  EXPECT_TRUE(contains(record.steps[0].reason, "double_precision")) << record.steps[0].reason;
}

// pbrt has no mirror that is coloured.
TEST(Stability, ASceneThatTheRendererCannotRenderIsNotApplicable) {
  const Sandbox sandbox;
  sandbox.add_to_good(R"(, "scene_format": "pbrt")");
  auto scene = sandbox.read("cases/m3_mirror/mirror.json");
  scene.replace(scene.find("[0.5,0.5,0.5]"), 13, "[0.9,0.5,0.1]");
  sandbox.write("coloured.json", scene);
  const auto answer = sandbox.orbs(
      {"stability", "coloured.json", "-r", "good", "--relation", "rotate,translate_matrix", "-o", "s"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  const auto record = record_of(sandbox, "s");
  ASSERT_EQ(record.steps.size(), 2);
  for (const auto& step : record.steps) {
    EXPECT_EQ(step.outcome, studies::StepOutcome::NotApplicable);
    EXPECT_TRUE(contains(step.reason, "cannot render the scene: material 'm'")) << step.reason;
  }
  EXPECT_TRUE(contains(answer.text, "not applicable")) << answer.text;
}

TEST(Stability, ARendererWithoutImagesBreaks) {
  const Sandbox sandbox;
  const auto answer =
      sandbox.orbs({"stability", "-r", "exit3", "-s", "grey", "--relation", "rotate", "-o", "s"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  const auto record = record_of(sandbox, "s");
  ASSERT_EQ(record.steps.size(), 1);
  EXPECT_EQ(record.steps[0].outcome, studies::StepOutcome::NoImage);
  EXPECT_TRUE(contains(record.steps[0].reason, "exit")) << record.steps[0].reason;
}

TEST(Stability, GoesOnWhereItWasInterrupted) {
  const Sandbox sandbox;
  ASSERT_EQ(sandbox.orbs(stability({"--relation", "rotate,mirror", "-o", "s"})).status, 0);
  auto record = record_of(sandbox, "s");
  record.steps.pop_back();
  record.steps[0].reason = "kept";
  sandbox.write("s/stability.json", studies::stability_json(record));
  ASSERT_EQ(sandbox.orbs(stability({"--relation", "rotate,mirror", "--resume", "s"})).status, 0);
  record = record_of(sandbox, "s");
  ASSERT_EQ(record.steps.size(), 2);
  EXPECT_EQ(record.steps[0].reason, "kept") << "measured once more";
  const auto other = sandbox.orbs(stability({"--relation", "rotate", "--resume", "s"}));
  EXPECT_EQ(other.status, 2);
  EXPECT_TRUE(contains(other.text, "has other scenes, renderers, relations or settings")) << other.text;
}

TEST(Stability, TakesSceneFiles) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"stability", "cases/m3_mirror/mirror.json", "-r", "good", "--relation",
                                    "rotate", "--side", "8", "-o", "s"});
  ASSERT_EQ(answer.status, 0) << answer.text;
  ASSERT_EQ(record_of(sandbox, "s").scenes.size(), 1);
  EXPECT_EQ(record_of(sandbox, "s").scenes[0].name, "mirror");
}

TEST(Stability, RefusesAnUnknownRelation) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs(stability({"--relation", "rotated", "-o", "s"}));
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "did you mean 'rotate'?")) << answer.text;
  EXPECT_FALSE(sandbox.has("s"));
}
