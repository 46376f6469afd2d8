#pragma once

#include "run/judge_targets.h"
#include "run/pace.h"
#include "run/render_session.h"

#include <cstddef>
#include <map>
#include <vector>

namespace orbs::run {

/// Jobs that share a target, whose looks are taken together; most are alone.
struct JobGroup {
  std::vector<std::size_t> jobs;         // of Plan::jobs
  std::vector<std::size_t> differences;  // of Plan::targets: those of two scenes
  // What its looks have shown so far.
  std::map<std::size_t, JudgedTarget> judged_differences{};  // by target
  int looks = 0;
  int spp = 0;                 // of the job with most
  double seconds = 0;          // that its renders have taken
  LookTime shorter_look = {};  // of the last two looks of different length
  LookTime longer_look = {};
  double seconds_to_decide = 0;  // about; of the target that needs most
  bool is_begun = false;
  bool is_done = false;
};

/// The next step of a group that is rendered in looks. The first takes over what an earlier run has left, or
/// takes the first look; each later one takes a look for the jobs whose targets are open. Writes into
/// `results` by job. Each look is put in place when it is complete: whoever kills the run loses that alone.
void take_look(RenderSession& session, JobGroup& group, std::vector<JudgedJob>& results);

/// Ends a group that is open when the run's budget is spent.
void end_by_run_budget(RenderSession& session, JobGroup& group, std::vector<JudgedJob>& results);

}  // namespace orbs::run
