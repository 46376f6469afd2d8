#include "json/document.h"
#include "json/object_reader.h"
#include "studies/effects/effect_cost.h"
#include "studies/effects/paired_interval.h"
#include "studies/effects/report.h"
#include "studies/effects/self_check.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;

studies::EffectCosts list_of(const studies::Alternative& way) {
  studies::EffectCosts list;
  list.scenes = {{"prism", "spectral", {"dispersion"}, 1.25e6, {way}}};
  return list;
}

studies::Alternative way(bool is_enough, const std::string& bias) {
  return {"other", is_enough, {1.5, 1.4, 1.6}, 2, {false, {-0.01, 0.0002}, {3.18, 1.03}, 40, 8, bias}};
}

bool says(const studies::EffectCosts& list, const std::string& text) {
  return studies::effect_cost_table(list, 0).find(text) != std::string::npos;
}

}  // namespace

TEST(EffectCostReport, SaysWhatIsLostWithItsError) {
  const auto list = list_of(way(false, "the mean is darker"));
  EXPECT_TRUE(says(list, "prism: spectral, 1.25 million paths per CPU second; dispersion"));
  EXPECT_TRUE(says(list, "mean -1.000 ± 0.020 %, most +318 ± 103 % at (40, 8)"))
      << studies::effect_cost_table(list, 0);
  EXPECT_TRUE(studies::all_agree(list));  // who leaves something out need not agree
}

TEST(EffectCostReport, ARicherTransportThatDiffersIsAnError) {
  const auto list = list_of(way(true, "the mean is darker"));
  EXPECT_TRUE(says(list, "DIFFERS: mean -1.000")) << studies::effect_cost_table(list, 0);
  EXPECT_FALSE(studies::all_agree(list));
  EXPECT_TRUE(studies::all_agree(list_of(way(true, ""))));
}

TEST(EffectCostReport, CausticsWithoutLightPathsAreNoError) {
  auto without = way(true, "the mean is darker");
  without.change.is_comparable = false;
  EXPECT_TRUE(studies::all_agree(list_of(without)));
  EXPECT_TRUE(says(list_of(without), "not compared"));
  without.change.bias = "";  // a firefly or two, whose noise explains anything
  EXPECT_TRUE(says(list_of(without), "not compared"));
}

TEST(EffectCostReport, MarkdownAndJsonHoldTheSame) {
  const auto list = list_of(way(false, ""));
  EXPECT_NE(studies::effect_cost_markdown(list).find(
                "| prism | spectral | other | 1.50 (1.40 to 1.60) | 2.00 | same but for noise |"),
            std::string::npos)
      << studies::effect_cost_markdown(list);
  const auto document = json::parse("effect-costs.json", studies::effect_cost_json(list));
  json::ObjectReader effect_costs(document);
  auto scenes = effect_costs.objects("scenes");
  auto ways = scenes.at(0).objects("alternatives");
  EXPECT_EQ(ways.at(0).text("change"), "same but for noise");
  EXPECT_EQ(ways.at(0).object("time_ratio").number("most"), 1.6);
}

// The same scene twice: a machine that slows one of the two by 5 % each time is told from chance.
TEST(EffectCostReport, TheSameSceneTwiceShowsWhatTheMachineDoes) {
  auto list = list_of(way(true, ""));
  list.other_load = {12, 3, 1, 0};
  EXPECT_EQ(studies::study_record(list).self_scenes, std::nullopt);
  auto again = way(true, "");
  again.time_interval = studies::paired_interval({1.05, 1.051, 1.049, 1.05});
  list.scenes.front().again = again;
  const auto study = studies::study_record(list);
  EXPECT_EQ(study.self_scenes, 1);
  EXPECT_EQ(study.self_differing, 1);
  EXPECT_NEAR(study.self_ratio.value(), 1.05, 1e-3);
  EXPECT_GT(study.self_low.value(), 1.04);
  EXPECT_EQ(study.disturbed, 1);
  EXPECT_TRUE(says(list, "in 1 of 12 renders, after 3 repeats")) << studies::effect_cost_table(list, 0);
  EXPECT_TRUE(says(list, "(A/A): time ratio 1.050")) << studies::effect_cost_table(list, 0);
}

TEST(EffectCostReport, ATimeOfZeroHasNoInterval) {
  EXPECT_FALSE(studies::paired_interval({0, 1, 1}));
  EXPECT_FALSE(studies::paired_interval({1}));
}
