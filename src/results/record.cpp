#include "results/record.h"

#include <algorithm>

namespace orbs::results {

std::string command_of(const RunRecord& run, const TargetRecord& target) {
  std::string commands;
  for (const auto& id : target.jobs)
    for (const auto& job : run.jobs)
      if (job.identity.id == id && !job.program.shell.empty())
        commands += (commands.empty() ? "" : " ; ") + job.program.shell;
  return commands;
}

bool judged_nothing(const RunRecord& run) {
  return std::all_of(run.targets.begin(), run.targets.end(),
                     [](const TargetRecord& target) { return target.verdict == Verdict::Unsupported; });
}

int exit_status(const RunRecord& run) {
  if (judged_nothing(run)) return 2;
  const bool failed = std::any_of(run.targets.begin(), run.targets.end(), [](const TargetRecord& target) {
    return target.declared && counts_as_failure(target.verdict);
  });
  return failed ? 1 : 0;
}

}  // namespace orbs::results
