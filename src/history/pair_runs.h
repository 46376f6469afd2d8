#pragma once

#include "results/record.h"

#include <string>
#include <vector>

namespace orbs::history {

/// One target by one renderer in two runs. Points into both records.
struct TargetPair {
  const results::TargetRecord* before;
  const results::TargetRecord* after;
  std::string not_rendered{};      // why there is nothing to compare; "" if both were rendered
  std::string not_compared{};      // why numbers of two images are not compared; "" if they are, or there are
                                   // not two
  bool has_other_samples = false;  // so that the errors of its two images are none of the same thing
};

/// One render in two runs, both of which left an image. Points into both records.
struct JobPair {
  const results::JobRecord* before;
  const results::JobRecord* after;
  std::string not_compared;  // why times are not compared; "" if they are
};

struct RunPair {
  std::vector<TargetPair> targets;
  std::vector<JobPair> jobs;
  std::vector<std::string> only_before;  // "cycles 101": targets that only one run has
  std::vector<std::string> only_after;   // "cycles 101 (fail)": with the state if it is a failure
};

/// Whether the target has an image that was compared with its reference.
inline bool has_numbers(const results::TargetRecord& target) { return !target.measures.empty(); }

/// Pairs by case, target and renderer, and renders by scene and renderer. InputError if the runs are of
/// different suites or sizes, or have no target in common.
RunPair pair_runs(const results::RunRecord& before, const results::RunRecord& after);

/// The targets of two renderers of one run, paired by case and target; no renders, whose times differ for
/// good reasons.
RunPair pair_renderers(const results::RunRecord& run, const std::string& before, const std::string& after);

}  // namespace orbs::history
