#include "results/record.h"

#include <algorithm>

namespace orbs::results {

std::string command_of(const RunRecord& run, const PictureRecord& picture) {
  std::string commands;
  for (const auto& id : picture.jobs)
    for (const auto& job : run.jobs)
      if (job.id == id && !job.command.empty()) commands += (commands.empty() ? "" : " ; ") + job.command;
  return commands;
}

bool judged_nothing(const RunRecord& run) {
  return std::all_of(run.pictures.begin(), run.pictures.end(),
                     [](const PictureRecord& picture) { return picture.verdict == Verdict::Unsupported; });
}

int exit_status(const RunRecord& run) {
  if (judged_nothing(run)) return 2;
  const bool failed = std::any_of(run.pictures.begin(), run.pictures.end(), [](const PictureRecord& picture) {
    return picture.declared && counts_as_failure(picture.verdict);
  });
  return failed ? 1 : 0;
}

}  // namespace orbs::results
