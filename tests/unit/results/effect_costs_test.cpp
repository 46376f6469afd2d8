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
