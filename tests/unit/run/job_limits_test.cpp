#include "run/prepare.h"

#include <gtest/gtest.h>

using namespace orbs;

TEST(JobLimits, TheShorterTimeOfRendererAndCaseHolds) {
  run::Plan plan;
  plan.renderers.push_back({{}, "/usr/bin/r"});
  plan.renderers[0].entry.limits.wall_seconds = 100;
  plan.scenes.push_back({"s", "s.json", 1, nullptr});
  const run::PlannedJob job;
  EXPECT_EQ(run::limits_of(plan, job).wall_seconds, 100);
  plan.scenes[0].wall_seconds = 7;
  EXPECT_EQ(run::limits_of(plan, job).wall_seconds, 7);
  plan.scenes[0].wall_seconds = 700;
  EXPECT_EQ(run::limits_of(plan, job).wall_seconds, 100);
}
