// How well a cluster is used: shards of a plan with the recorded times of renders, handed out as Slurm does.
#include "json/document.h"
#include "json/object_reader.h"
#include "runner/shard.h"
#include "runner/slurm.h"

#include <algorithm>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

// CPU seconds at a quarter of the size, which has a sixteenth of the pixels.
std::vector<double> seconds_at_full_size() {
  constexpr double kPixels = 16;
  const auto document =
      json::parse_file(std::filesystem::path(ORBS_SOURCE_DIR) / "data/bench/render-times.json");
  json::ObjectReader in(document);
  std::vector<double> seconds;
  for (auto& render : in.objects("renders"))
    seconds.push_back(kPixels * render.number("cpu_seconds", json::kPositive));
  return seconds;
}

// The share of the time of all nodes in which they render, until the last one is done.
double efficiency(std::size_t jobs, int shards, int nodes, double start_seconds) {
  const auto recorded = seconds_at_full_size();
  const auto time_of = [&](std::size_t job) { return recorded[job % recorded.size()]; };
  runner::Plan plan;
  plan.jobs.resize(jobs);
  const auto shard_of = runner::shards_of_jobs(plan, shards);
  double rendering = 0;
  std::vector<double> tasks(static_cast<std::size_t>(shards), start_seconds);
  for (std::size_t job = 0; job < jobs; ++job) {
    rendering += time_of(job);
    tasks[static_cast<std::size_t>(shard_of[job] - 1)] += time_of(job);
  }
  // The next task of an array starts on the node that is free first.
  std::vector<double> free_at(static_cast<std::size_t>(nodes), 0);
  for (const double task : tasks) *std::min_element(free_at.begin(), free_at.end()) += task;
  return rendering / (nodes * *std::max_element(free_at.begin(), free_at.end()));
}

}  // namespace

// 5 s to start a task is more than orbs takes to plan 10,000 renders.
TEST(Cluster, Of64NodesRendersForAtLeast90PercentOfTheTime) {
  EXPECT_GE(efficiency(10'000, runner::kMostShards, 64, 5), 0.9);
}

// One task for each node waits for the slowest of them, so that it must not be the default.
TEST(Cluster, IsUsedWorseWithOneTaskForEachNode) {
  EXPECT_LT(efficiency(1000, 64, 64, 5), efficiency(1000, runner::kMostShards, 64, 5));
}
