// The goals of the tracer's speed, and the part of docs/reports/cost.md that the committed study makes.
#include "structure/documentation.h"
#include "studies/cost/goals.h"
#include "studies/cost/json.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace orbs::studies;

namespace {

// Two renderers whose relmse is `noise` / samples; a sample takes so many seconds.
struct MadeUp {
  double noise = 1e-2;
  double seconds_per_sample = 0.01;
  double start_seconds = 0.5;
};

void add(CostRecord& record, std::size_t target, std::size_t renderer, const MadeUp& truth) {
  Sweep sweep{target, renderer, {}, "", ""};
  CostRender fixed{.target = target, .renderer = renderer, .purpose = Purpose::FixedCost};
  fixed.cpu_seconds = truth.start_seconds;
  record.renders.push_back(fixed);
  for (const int spp : {4, 8, 16, 32, 64, 128, 256, 512}) {
    sweep.settings.push_back({std::to_string(spp) + " spp", spp});
    for (const double around : {0.99, 1.0, 1.01}) {
      CostRender render{
          .target = target, .renderer = renderer, .setting = sweep.settings.back().name, .spp = spp};
      render.seed = static_cast<int>(100 * around);
      render.cpu_seconds = truth.start_seconds + truth.seconds_per_sample * spp * around;
      render.relmse = truth.noise / spp * around;
      render.psnr_srgb8 = -10 * std::log10(*render.relmse);
      record.renders.push_back(render);
    }
  }
  record.sweeps.push_back(sweep);
}

// Ours takes a quarter of the time for the same samples, with 0.8 of their error.
CostRecord three_scenes(double slowest_seconds_per_sample = 0.0025) {
  CostRecord record;
  record.started = "2026-01-02T03:04:05";
  for (const char* name : {"ours", "theirs"}) record.renderers.push_back({name, "1", SweepOf::Samples, ""});
  for (std::size_t t = 0; t < 3; ++t) {
    record.targets.push_back({"t" + std::to_string(t), "M1", "", 8, 8, "", {}});
    const double scatter = 1 + 0.01 * static_cast<double>(t);
    add(record, t, 0, {0.008 * scatter, t == 2 ? slowest_seconds_per_sample : 0.0025, 0.1});
    add(record, t, 1, {0.01, 0.01, 0.5});
  }
  return record;
}

}  // namespace

TEST(CostGoals, AreRatiosOfTheTwoRenderers) {
  const auto goals = cost_goals(three_scenes(), "ours", "theirs");
  ASSERT_EQ(goals.size(), 3);
  ASSERT_TRUE(goals[0].mean && goals[1].mean && goals[2].mean);
  EXPECT_NEAR(goals[0].mean->value, 0.25 * 0.8 * 1.01, 0.01) << "the start is left out";
  // 35 dB are an error of 3.16e-4: 25.3 samples of ours, 31.6 of theirs.
  EXPECT_NEAR(goals[1].mean->value, (0.1 + 25.5 * 0.0025) / (0.5 + 31.6 * 0.01), 0.01);
  EXPECT_NEAR(goals[2].mean->value, 0.8 * 1.01, 0.005);
  for (const auto& goal : goals) {
    EXPECT_EQ(goal.scenes, 3) << goal.name;
    EXPECT_EQ(reached_text(goal), "yes") << goal.name;
  }
}

TEST(CostGoals, OneSceneThatIsTooSlowIsNamed) {
  const auto goal = cost_goals(three_scenes(0.0125), "ours", "theirs").at(0);
  EXPECT_EQ(reached_text(goal), "no");
  EXPECT_EQ(goal.worst_scene, "t2");
  EXPECT_NEAR(goal.worst, 1.25 * 0.8 * 1.02, 0.02);
}

TEST(CostGoals, WhatTheIntervalDoesNotDecideIsNotShown) {
  CostGoal goal{"", 0.5, {}, orbs::Interval{0.4, 0.3, 0.6}};
  EXPECT_EQ(reached_text(goal), "not shown");
  goal.mean = orbs::Interval{0.4, 0.3, 0.5};
  EXPECT_EQ(reached_text(goal), "yes");
  goal.mean = orbs::Interval{0.7, 0.6, 0.8};
  EXPECT_EQ(reached_text(goal), "no");
  goal.mean.reset();
  EXPECT_EQ(reached_text(goal), "not measured");
}

TEST(CostGoals, ThePageShowsTheCommittedStudy) {
  const std::filesystem::path reports = std::filesystem::path(ORBS_SOURCE_DIR) / "docs/reports";
  const auto text = goals_markdown(read_cost_file(reports / "cost-1-4.json"), "orbs", "cycles");
  EXPECT_EQ(orbs::structure::check_generated_part(reports / "cost.md", "goals of speed", text), "");
}
