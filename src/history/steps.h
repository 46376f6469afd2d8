#pragma once

#include "history/change.h"
#include "history/series.h"

#include <cstddef>
#include <vector>

namespace orbs::history {

/// A number over runs, the oldest first.
struct Values {
  std::vector<std::size_t> runs;  // of History::runs
  std::vector<double> numbers;
  double most_degrees = 1e9;  // of freedom that Student's test may take; few for numbers with outliers
};

/// Where a number changed, if it did.
struct Split {
  std::size_t at = 0;  // index of the first value after the step
  double before = 0;   // means
  double after = 0;
  double probability = 1;  // that equal programs have so clear a step anywhere
};

/// The place where Student's test with a common variance of both sides is the most certain. At least three
/// values are needed; equal values have a step nowhere.
Split best_split(const Values& values);

/// Fewer runs say too little of their scatter for a step to be told from it.
inline constexpr std::size_t kFewestRuns = 5;

/// The clearest step of each number over the runs: light and time of each renderer as a whole, and light,
/// error and time of each target. For each place between two runs Student's test compares the means before
/// and after (the scatter within both is the noise, that of the machine from run to run included); the best
/// place counts, and its probability is multiplied by the number of places. In 1 of 100 histories of equal
/// programs any step is found (kFalseAlarms, shared as in compare_runs); smaller steps than kLeastLight,
/// kLeastError and kLeastTime are not reported. Worse ones come first.
std::vector<Change> find_steps(const History& history);

}  // namespace orbs::history
