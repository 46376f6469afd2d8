#include "studies/cost/other_load.h"

#include "studies/cost/numbers.h"
#include "studies/cost/report.h"
#include "studies/cost/schedule.h"

#include <gtest/gtest.h>

using namespace orbs::studies;

namespace {

// A renderer beside which others take these shares of the machine, one attempt after the other.
std::function<std::optional<CostRender>()> renderer_beside(const std::vector<double>& shares, int& attempts) {
  return [&attempts, shares]() -> std::optional<CostRender> {
    CostRender render;
    render.other_share = shares.at(static_cast<std::size_t>(attempts++));
    return render;
  };
}

}  // namespace

TEST(OtherLoad, ADisturbedRenderIsRepeatedUntilItIsUndisturbed) {
  int attempts = 0;
  const auto made = undisturbed_render(renderer_beside({0.4, 0.02, 0.0}, attempts));
  EXPECT_EQ(attempts, 2);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->repeats, 1);
  EXPECT_FALSE(is_disturbed(*made));
}

TEST(OtherLoad, ARenderThatStaysDisturbedIsRepeatedTwiceAndLeftOut) {
  int attempts = 0;
  const auto made = undisturbed_render(renderer_beside({0.4, 0.06, 0.3, 0.0}, attempts));
  EXPECT_EQ(attempts, 3);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->repeats, 2);
  EXPECT_TRUE(is_disturbed(*made));
}

// On a machine in use all 24 of 24 renders were left out, after 102 s without a word.
TEST(OtherLoad, WhereEveryRenderIsDisturbedTheyCountAndAreNamed) {
  CostRecord record;
  record.is_finished = true;
  record.targets.push_back({"t", "M1", "", 8, 8, "", {}});
  record.renderers.push_back({"r", "1", SweepOf::Samples, ""});
  record.sweeps.push_back({0, 0, {{"4 spp", 4}}, "", ""});
  for (const double share : {0.4, 0.5})
    record.renders.push_back(
        {.setting = "4 spp", .spp = 4, .cpu_seconds = 1, .other_share = share, .relmse = 1});
  const auto numbers = cost_numbers(record);
  EXPECT_EQ(numbers.curves.at(0).points.at(0).renders, 2);
  EXPECT_EQ(numbers.other_load.left_out, 0);
  EXPECT_EQ(numbers.other_load.marked, 2);
  EXPECT_NE(other_load_text(numbers.other_load).find("2 renders count although others took as much"),
            std::string::npos);
  EXPECT_EQ(unmeasured_text(record, record.sweeps[0]), "disturbed by other work: 4 spp");
}

TEST(OtherLoad, OnAMachineThatStaysInUseNothingIsRepeated) {
  int attempts = 0;
  const auto made = undisturbed_render(renderer_beside({0.4, 0.3}, attempts), 0);
  EXPECT_EQ(attempts, 1);
  EXPECT_TRUE(made && is_disturbed(*made));
}

TEST(OtherLoad, WhatIsLeftOutIsInNoNumberAndIsCounted) {
  CostRecord record;
  record.is_finished = true;
  record.targets.push_back({"t", "M1", "", 8, 8, "", {}});
  record.renderers.push_back({"r", "1", SweepOf::Samples, ""});
  record.sweeps.push_back({0, 0, {{"4 spp", 4}}, "", ""});
  for (const double share : {0.0, 0.04, 0.5})
    record.renders.push_back({.setting = "4 spp",
                              .spp = 4,
                              .cpu_seconds = share > 0.05 ? 100.0 : 1.0,
                              .other_share = share,
                              .relmse = 1});
  record.renders.back().repeats = 2;
  record.renders.push_back({.setting = "4 spp", .spp = 4, .cpu_seconds = 1, .relmse = 1});  // not known
  const auto numbers = cost_numbers(record);
  EXPECT_EQ(numbers.curves.at(0).points.at(0).renders, 3);
  EXPECT_EQ(numbers.curves.at(0).points.at(0).cpu_seconds.high, 1);
  EXPECT_EQ(numbers.other_load.left_out, 1);
  const auto text = cost_table(record, {});
  EXPECT_NE(
      text.find(
          "of 4 renders 1 were left out because others took more than 5 % of its processors; 2 repeats"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("of 1 renders it is not known"), std::string::npos) << text;
}
