#pragma once

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

}  // namespace orbs::history
