// How well many machines are used: shards of a large plan on a made-up cluster, with render times as
// recorded.
#include "base/random.h"
#include "run/cluster/shard.h"
#include "run/cluster/slurm.h"
#include "run/plan/render_seconds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <queue>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

// As make_plan does.
void expect_times(run::Plan& plan) {
  const auto seconds = run::estimated_cpu_seconds(plan);
  for (std::size_t job = 0; job < plan.jobs.size(); ++job) plan.jobs[job].cpu_seconds = seconds[job];
}

// Renders of the scenes with recorded times, over and over, up to `count`.
run::Plan plan_of(int count) {
  run::Plan plan;
  plan.root = ORBS_SOURCE_DIR;
  plan.suite.name = "orbs";
  plan.settings.size_divisor = registry::QuarterSize;
  for (const char* name : {"orbs", "cycles"}) {
    run::ChosenRenderer renderer;
    renderer.entry.name = name;
    plan.renderers.push_back(renderer);
  }
  for (const char* name :
       {"101", "102", "103", "110", "113", "124", "201", "215", "232", "305", "248-full"}) {
    run::PlannedScene scene;
    scene.name = name;
    scene.size_divisor = plan.settings.size_divisor;
    plan.scenes.push_back(scene);
  }
  for (int i = 0; i < count; ++i) {
    run::PlannedJob job;
    job.scene = static_cast<std::size_t>(i) % plan.scenes.size();
    job.renderer = static_cast<std::size_t>(i) / plan.scenes.size() % plan.renderers.size();
    plan.jobs.push_back(job);
  }
  expect_times(plan);
  return plan;
}

// The share of its time in which a cluster of `nodes` renders, when each free node takes the next shard.
double efficiency(const std::vector<double>& seconds_of_shards, int nodes) {
  std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
  for (int node = 0; node < nodes; ++node) free_at.push(0);
  double end = 0;
  for (const double seconds : seconds_of_shards) {
    const double done = free_at.top() + seconds;
    free_at.pop();
    free_at.push(done);
    end = std::max(end, done);
  }
  return std::accumulate(seconds_of_shards.begin(), seconds_of_shards.end(), 0.0) / (end * nodes);
}

}  // namespace

TEST(ShippedTimes, AreScaledToOtherSizesScenesSuitesAndRenderers) {
  auto plan = plan_of(20);
  plan.jobs[0].spp = 80;
  const auto quarter = run::shipped_cpu_seconds(plan);
  for (const auto& time : quarter) {
    ASSERT_TRUE(time);
    EXPECT_FALSE(time->is_rough);
  }
  plan.jobs[0].spp = 160;
  EXPECT_NEAR(run::shipped_cpu_seconds(plan)[0]->cpu_seconds, 2 * quarter[0]->cpu_seconds, 1e-9);
  plan.settings.size_divisor = registry::FullSize;
  for (auto& scene : plan.scenes) scene.size_divisor = 1;
  plan.jobs[0].first_spp = 16;
  const auto needed = run::shipped_cpu_seconds(plan)[0]->cpu_seconds;
  plan.jobs[0].spp *= 8;
  EXPECT_EQ(run::shipped_cpu_seconds(plan)[0]->cpu_seconds, needed) << "the verdict takes what it needs";
  plan.jobs[0].spp /= 8;
  plan.jobs[0].first_spp = 0;
  const auto full = run::shipped_cpu_seconds(plan);
  EXPECT_NEAR(full[1]->cpu_seconds, 16 * quarter[1]->cpu_seconds, 1e-9);
  EXPECT_TRUE(full[1]->is_rough);
  plan.suite.name = "gi";
  plan.renderers[1].entry.name = "pbrt";
  for (const auto& time : run::shipped_cpu_seconds(plan)) {
    ASSERT_TRUE(time);
    EXPECT_TRUE(time->is_rough);
    EXPECT_GT(time->cpu_seconds, 0);
  }
}

TEST(Cluster, NineTenthsOf64NodesRenderAlthoughTimesAreKnownRoughly) {
  constexpr int kJobs = 10'000;
  constexpr int kNodes = 64;
  constexpr double kSigma = 0.4;  // of the logarithm of a true time over the recorded one
  const auto plan = plan_of(kJobs);
  const auto expected = run::estimated_cpu_seconds(plan);
  constexpr int kShards = run::kMostShards;  // as orbs submit has them; a free node takes the next
  const auto shards = run::shards_of_jobs(plan, kShards);
  std::vector<double> seconds(kShards);
  for (std::size_t job = 0; job < plan.jobs.size(); ++job) {
    const double radius = std::sqrt(-2 * std::log(1 - unit_random(mix(1, job))));
    const double normal = radius * std::cos(2 * std::numbers::pi * unit_random(mix(2, job)));
    seconds[static_cast<std::size_t>(shards[job] - 1)] += expected[job] * std::exp(kSigma * normal);
  }
  EXPECT_GT(efficiency(seconds, kNodes), 0.9);
}

TEST(Cluster, NoShardTakesMuchLongerThanAnother) {
  const auto plan = plan_of(1000);
  const auto expected = run::estimated_cpu_seconds(plan);
  const auto [least, most] = std::minmax_element(expected.begin(), expected.end());
  ASSERT_GT(*most, 5 * *least);  // else dealing out in turn would do
  const auto shards = run::shards_of_jobs(plan, 64);
  std::vector<double> seconds(64);
  for (std::size_t job = 0; job < shards.size(); ++job)
    seconds[static_cast<std::size_t>(shards[job] - 1)] += expected[job];
  EXPECT_TRUE(std::is_sorted(seconds.rbegin(), seconds.rend()));
  EXPECT_LE(seconds.front() - seconds.back(), *most);
  EXPECT_GT(efficiency(seconds, 64), 0.95);
}

TEST(Cluster, RendersOfOneDifferenceStayTogether) {
  auto plan = plan_of(100);
  for (std::size_t i = 0; i + 1 < plan.jobs.size(); i += 2) {
    run::PlannedTarget target;
    target.jobs = {i, i + 1};
    plan.targets.push_back(target);
  }
  const auto shards = run::shards_of_jobs(plan, 7);
  for (std::size_t i = 0; i + 1 < shards.size(); i += 2) EXPECT_EQ(shards[i], shards[i + 1]);
  EXPECT_EQ(run::shard_count(plan), 50);
}

TEST(Cluster, RendersWithoutRecordedTimesAreSharedOutEvenly) {
  auto plan = plan_of(96);
  plan.root = ORBS_BINARY_DIR;  // without a file of times
  expect_times(plan);
  std::vector<int> count(8);
  for (const int shard : run::shards_of_jobs(plan, 8)) ++count[static_cast<std::size_t>(shard - 1)];
  EXPECT_EQ(count, std::vector<int>(8, 12));
}
