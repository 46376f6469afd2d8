#include "results/record.h"

#include <algorithm>

namespace orbs::results {

JobsById jobs_by_id(const RunRecord& run) {
  JobsById jobs;
  for (const auto& job : run.jobs) jobs.try_emplace(job.identity.id, &job);
  return jobs;
}

std::string command_of(const JobsById& jobs, const TargetRecord& target) {
  std::string commands;
  for (const auto& id : target.jobs)
    if (const auto job = jobs.find(id); job != jobs.end() && !job->second->program.shell.empty())
      commands += (commands.empty() ? "" : " ; ") + job->second->program.shell;
  return commands;
}

bool judged_nothing(const RunRecord& run) {
  return std::all_of(run.targets.begin(), run.targets.end(),
                     [](const TargetRecord& target) { return target.verdict == Verdict::Unsupported; });
}

int exit_status(const RunRecord& run) {
  if (judged_nothing(run)) return 2;
  const bool failed = std::any_of(run.targets.begin(), run.targets.end(), [](const TargetRecord& target) {
    return target.declared && counts_as_failure(target.verdict, target.expectation);
  });
  return failed ? 1 : 0;
}

}  // namespace orbs::results
