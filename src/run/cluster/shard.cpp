#include "run/cluster/shard.h"

#include "base/error.h"
#include "base/nth.h"
#include "run/plan/job_groups.h"
#include "run/plan/plan_file.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace orbs::run {

namespace {

// By group, whose number is that of its first job; 0 for numbers that are no group's.
std::vector<double> seconds_of_groups(const std::vector<std::size_t>& groups, const Plan& plan) {
  std::vector<double> seconds(groups.size());
  for (std::size_t job = 0; job < groups.size(); ++job) seconds[groups[job]] += plan.jobs[job].cpu_seconds;
  return seconds;
}

// Pairs of seconds and index, without those of no seconds, the longest first; of equal ones the first.
std::vector<std::pair<double, std::size_t>> longest_first(const std::vector<double>& seconds) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < seconds.size(); ++i)
    if (seconds[i] > 0) order.emplace_back(seconds[i], i);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  return order;
}

// The jobs of the shard, as a flag for each job.
std::vector<bool> own_jobs(const registry::Shard& shard, const Plan& plan) {
  std::vector<bool> is_own;
  for (const int index : shards_of_jobs(plan, shard.count)) is_own.push_back(index == shard.index);
  return is_own;
}

void keep_jobs(const std::vector<bool>& is_own, bool is_first, Plan& plan) {
  std::vector<std::size_t> new_index(plan.jobs.size());
  std::vector<PlannedJob> jobs;
  for (std::size_t job = 0; job < plan.jobs.size(); ++job) {
    new_index[job] = jobs.size();
    if (is_own[job]) jobs.push_back(std::move(plan.jobs[job]));
  }
  std::erase_if(plan.targets, [&](const PlannedTarget& target) {
    return target.jobs.empty() ? !is_first : !is_own[target.jobs.front()];
  });
  for (auto& target : plan.targets)
    for (auto& job : target.jobs) job = new_index[job];
  plan.jobs = std::move(jobs);
}

// Scenes that are rendered somewhere else stand in that shard's record; what nobody renders, in the first.
void keep_scenes(const std::set<std::size_t>& rendered, bool is_first, Plan& plan) {
  std::set<std::size_t> used;
  for (const auto& job : plan.jobs) used.insert(job.scene);
  std::vector<std::size_t> new_index(plan.scenes.size());
  std::vector<PlannedScene> scenes;
  for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
    new_index[scene] = scenes.size();
    if (used.contains(scene) || (is_first && !rendered.contains(scene)))
      scenes.push_back(std::move(plan.scenes[scene]));
  }
  for (auto& job : plan.jobs) job.scene = new_index[job.scene];
  plan.scenes = std::move(scenes);
}

void keep_cases(Plan& plan) {
  std::set<std::size_t> used;
  for (const auto& target : plan.targets) used.insert(target.one_case);
  std::vector<std::size_t> new_index(plan.cases.size());
  std::vector<registry::Case> cases;
  for (std::size_t i = 0; i < plan.cases.size(); ++i) {
    new_index[i] = cases.size();
    if (used.contains(i)) cases.push_back(std::move(plan.cases[i]));
  }
  for (auto& target : plan.targets) target.one_case = new_index[target.one_case];
  plan.cases = std::move(cases);
}

}  // namespace

std::vector<int> shards_of_jobs(const Plan& plan, int count) {
  const auto groups = group_of_jobs(plan);
  const auto order = longest_first(seconds_of_groups(groups, plan));
  // The shard that has least to do gets the next group.
  using Load = std::pair<double, int>;
  std::priority_queue<Load, std::vector<Load>, std::greater<>> loads;
  for (int shard = 0; shard < count; ++shard) loads.emplace(0, shard);
  std::vector<int> shard_of_group(plan.jobs.size());
  std::vector<double> seconds(static_cast<std::size_t>(count));
  for (const auto& [group_seconds, group] : order) {
    const auto [load, shard] = loads.top();
    loads.pop();
    shard_of_group[group] = shard;
    nth(seconds, shard) = load + group_seconds;
    loads.emplace(load + group_seconds, shard);
  }
  // A cluster starts the tasks of an array by their numbers: shards that take longest come first.
  std::vector<int> number(seconds.size());
  int next = 0;
  for (const auto& [load, shard] : longest_first(seconds)) number[shard] = ++next;
  std::vector<int> shards;
  for (const auto group : groups) shards.push_back(nth(number, shard_of_group[group]));
  return shards;
}

int shard_count(const Plan& plan) {
  const auto groups = group_of_jobs(plan);
  int count = 0;
  for (std::size_t job = 0; job < groups.size(); ++job)
    if (groups[job] == job) ++count;
  return count;
}

void take_shard(const registry::Shard& shard, Plan& plan) {
  if (shard.count == 1) return;
  const auto count = plan.jobs.size();
  const bool is_first = shard.index == 1;
  const auto is_own = own_jobs(shard, plan);
  std::set<std::size_t> rendered;
  for (const auto& job : plan.jobs) rendered.insert(job.scene);
  keep_jobs(is_own, is_first, plan);
  if (plan.jobs.empty())
    throw InputError(fmt::format("shard {} has nothing to render: the plan has {} renders",
                                 registry::shard_text(shard), count));
  keep_scenes(rendered, is_first, plan);
  keep_cases(plan);
}

void take_targets(const std::vector<OnlyTarget>& only, Plan& plan) {
  const std::set<OnlyTarget> chosen(only.begin(), only.end());
  std::erase_if(plan.targets, [&](const PlannedTarget& target) {
    return !chosen.contains(
        {plan.renderers[target.renderer].entry.name, plan.cases[target.one_case].name, target.target});
  });
  std::vector<bool> is_needed(plan.jobs.size());
  for (const auto& target : plan.targets)
    for (const auto job : target.jobs) is_needed[job] = true;
  std::set<std::size_t> rendered;
  for (const auto& job : plan.jobs) rendered.insert(job.scene);
  keep_jobs(is_needed, true, plan);
  keep_scenes(rendered, false, plan);
  keep_cases(plan);
  plan.id = plan_id(plan);
}

}  // namespace orbs::run
