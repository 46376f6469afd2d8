#include "studies/cost/numbers.h"
#include "studies/cost/report.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

using namespace orbs::studies;

namespace {

// One renderer on so many scenes, rendered four times and four times again. `drift` makes the second of them
// longer; `scatter` is of a single time.
CostRecord twice(std::size_t scenes, double drift, double scatter) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  CostRecord record;
  record.is_finished = true;
  record.renderers.push_back({"r", "1", SweepOf::Samples, ""});
  for (std::size_t t = 0; t < scenes; ++t) {
    record.targets.push_back({"t" + std::to_string(t), "M1", "", 8, 8, "", {}});
    record.sweeps.push_back({t, 0, {{"64 spp", 64}}, "", ""});
    for (const auto purpose : {Purpose::Sweep, Purpose::Again})
      for (int seed = 0; seed < 4; ++seed) {
        CostRender render{.target = t, .purpose = purpose, .setting = "64 spp", .spp = 64, .seed = seed};
        render.cpu_seconds = std::exp(scatter * normal(random)) * (purpose == Purpose::Again ? drift : 1.0);
        render.relmse = 1e-3 * std::exp(scatter * normal(random));
        record.renders.push_back(render);
      }
  }
  return record;
}

}  // namespace

TEST(SelfComparison, SpansAllScenesAndSaysHowFarTheirRatiosScatter) {
  const auto record = twice(20, 1, 0.03);
  const auto found = cost_numbers(record).self_comparison;
  ASSERT_TRUE(found);
  EXPECT_EQ(found->scenes.size(), 20);
  EXPECT_TRUE(found->passed);
  // The ratio of two means of four, each with a scatter of 3 %: 0.03 sqrt(2 / 4).
  EXPECT_NEAR(found->time_scatter, 0.03 * std::sqrt(0.5), 0.01);
  EXPECT_LT(found->time_spread.least, 1);
  EXPECT_GT(found->time_spread.most, 1);
  EXPECT_NE(cost_table(record, {}).find("r twice on 20 scenes: time "), std::string::npos);
}

// On one scene a drift of 2 % is lost in the scatter of the seeds; on 20 it is not.
TEST(SelfComparison, ManyScenesShowASmallDrift) {
  EXPECT_TRUE(cost_numbers(twice(1, 1.02, 0.03)).self_comparison->passed);
  const auto found = cost_numbers(twice(20, 1.03, 0.03)).self_comparison;
  EXPECT_FALSE(found->passed);
  EXPECT_TRUE(found->is_known);
}

TEST(MeanRatio, IsWhatTheTableShows) {
  // Times of scenes whose logarithms have the mean 0.7 and scatter.
  const std::vector<LogRatio> logs{{0.6, 1e-4, 3}, {0.7, 1e-4, 3}, {0.8, 1e-4, 3}};
  const auto mean = ratio_interval(mean_over(logs));
  EXPECT_NEAR(mean.value, std::exp(0.7), 1e-9);
  EXPECT_NEAR(std::log(mean.high / mean.value), 4.3027 * 0.1 / std::sqrt(3), 1e-4) << "Student, 2 degrees";
  const auto one = ratio_interval(mean_over({{0.7, 1e-4, 3}}));
  EXPECT_NEAR(std::log(one.high / one.value), 3.1824 * 0.01, 1e-5) << "of its seeds, 3 degrees";
}
