#include "results/effect_costs.h"

#include "base/error.h"
#include "structure/source_files.h"

#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr const char* kTwoScenes = R"({"format": "orbs-effect-cost/1", "scenes": [
  {"scene": "a", "alternatives": [
    {"name": "polarised", "time_ratio": {"median": 1.5}, "error_ratio": 1.25, "change": "same to the bit"},
    {"name": "rgb", "time_ratio": {"median": 0.5}, "error_ratio": 0, "change": "mean -8 %"}]},
  {"scene": "b", "alternatives": []}]})";

}  // namespace

TEST(EffectCosts, AreFoundByScene) {
  const structure::TestFolder scratch("results-effect costs");
  scratch.write("effect-costs.json", kTwoScenes);
  const auto effect_costs = results::read_effect_costs(scratch.path() / "effect-costs.json");
  ASSERT_EQ(effect_costs.size(), 1U);
  ASSERT_EQ(effect_costs.at("a").size(), 2U);
  EXPECT_EQ(effect_costs.at("a")[0].name, "polarised");
  EXPECT_EQ(effect_costs.at("a")[0].time_ratio, 1.5);
  EXPECT_EQ(effect_costs.at("a")[0].error_ratio, 1.25);
  EXPECT_EQ(effect_costs.at("a")[1].change, "mean -8 %");
}

TEST(EffectCosts, NobodyNeedsToHaveAsked) {
  EXPECT_TRUE(results::read_effect_costs("/no/such/effect-costs.json").empty());
}

TEST(EffectCosts, AnotherFileSaysWhatItShouldBe) {
  const structure::TestFolder scratch("results-effect costs");
  scratch.write("effect-costs.json", R"({"format": "orbs-run/1"})");
  EXPECT_THROW(results::read_effect_costs(scratch.path() / "effect-costs.json"), InputError);
}

TEST(EffectCosts, AnOlderFileHasTheRangeOfItsRounds) {
  const structure::TestFolder scratch("results-effect costs");
  scratch.write("effect-costs.json", R"({"format": "orbs-effect-cost/1", "load": 3.5, "rounds": 4, "scenes": [
    {"scene": "a", "alternatives": [{"name": "rgb", "time_ratio": {"median": 0.5, "least": 0.4, "most": 0.6},
     "error_ratio": 0, "change": "x", "is_comparable": false}]}]})");
  const auto file = scratch.path() / "effect-costs.json";
  const auto cost = results::read_effect_costs(file).at("a").at(0);
  EXPECT_EQ(cost.time_low, 0.4);
  EXPECT_EQ(cost.time_high, 0.6);
  EXPECT_FALSE(cost.is_comparable);
  const auto study = results::read_effect_study(file);
  ASSERT_TRUE(study);
  EXPECT_EQ(study->load, 3.5);
  EXPECT_FALSE(study->has_intervals);
  EXPECT_FALSE(study->self_ratio);
}

TEST(EffectCosts, AFileOfTodayHasIntervalsAndItsCheck) {
  const structure::TestFolder scratch("results-effect costs");
  scratch.write("effect-costs.json", R"({"format": "orbs-effect-cost/1",
    "study": {"rounds": 4, "has_intervals": true, "self_scenes": 2, "self_ratio": 1.01}, "scenes": [
    {"scene": "a", "alternatives": [{"name": "rgb", "time_ratio": {"median": 0.5, "least": 0.4, "most": 0.6},
     "time_interval": {"low": 0.45, "high": 0.55}, "error_ratio": 0, "change": "x"}]}]})");
  const auto file = scratch.path() / "effect-costs.json";
  EXPECT_EQ(results::read_effect_costs(file).at("a").at(0).time_high, 0.55);
  const auto study = results::read_effect_study(file);
  ASSERT_TRUE(study);
  EXPECT_TRUE(study->has_intervals);
  EXPECT_EQ(study->self_ratio, 1.01);
}
