#include "runner/shard.h"

#include "base/error.h"
#include "base/files.h"
#include "registry/image_size.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace orbs::runner {

namespace {

// The first job of each job's group: those that share a target, by union and find.
std::vector<std::size_t> groups_of(const Plan& plan) {
  std::vector<std::size_t> first(plan.jobs.size());
  std::iota(first.begin(), first.end(), 0);
  const auto find = [&](std::size_t job) {
    while (first[job] != job) {
      first[job] = first[first[job]];  // halves the path, so that the next search is short
      job = first[job];
    }
    return job;
  };
  for (const auto& target : plan.targets)
    for (const auto job : target.jobs) {
      const auto a = find(target.jobs.front());
      const auto b = find(job);
      first[std::max(a, b)] = std::min(a, b);
    }
  for (std::size_t job = 0; job < first.size(); ++job) first[job] = find(job);
  return first;
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

results::JobList job_list(const Plan& plan) {
  results::JobList list;
  auto hash =
      content_hash(fmt::format("{} {}", plan.suite.name, registry::size_text(plan.settings.size_divisor)));
  for (const auto& one_case : plan.cases) hash = content_hash(read_file(one_case.file), hash);
  for (const auto& scene : plan.scenes) {
    list.scenes.push_back(scene.name);
    hash = content_hash(plan.reference_hashes.at(scene.name), hash);
  }
  for (const auto& job : plan.jobs) {
    list.jobs.push_back({job.id, plan.renderers[job.renderer].entry.name, plan.scenes[job.scene].name});
    hash = content_hash(job.id, hash);
  }
  for (const auto& target : plan.targets) {
    auto& listed = list.targets.emplace_back();
    listed.case_name = plan.cases[target.one_case].name;
    listed.target = target.target;
    listed.renderer = plan.renderers[target.renderer].entry.name;
    for (const auto job : target.jobs) listed.jobs.push_back(plan.jobs[job].id);
    hash = content_hash(fmt::format("{} {} {}", listed.case_name, listed.target, listed.renderer), hash);
  }
  list.plan = hash_text(hash);
  return list;
}

std::vector<int> shards_of_jobs(const Plan& plan, int count) {
  const auto groups = groups_of(plan);
  std::vector<int> shards(plan.jobs.size());
  int next = 0;
  for (std::size_t job = 0; job < groups.size(); ++job)
    shards[job] = groups[job] == job ? next++ % count + 1 : shards[groups[job]];
  return shards;
}

int shard_count(const Plan& plan) {
  const auto groups = groups_of(plan);
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

}  // namespace orbs::runner
