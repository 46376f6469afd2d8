#include "run/plan/job_groups.h"

#include <algorithm>
#include <numeric>

namespace orbs::run {

// By union and find.
std::vector<std::size_t> group_of_jobs(const Plan& plan) {
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

}  // namespace orbs::run
