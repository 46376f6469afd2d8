#pragma once

#include "history/change.h"
#include "history/pair_runs.h"

#include <vector>

namespace orbs::history {

/// Renders of less CPU time are not compared: starting the program and the clock's ticks of 10 ms rule them.
inline constexpr double kLeastSeconds = 0.2;

/// Tests of CPU times, for which each renderer's own renders say how much times scatter. What is tested is
/// whether a time changed by more than kLeastTime, since a machine as a whole is a few per cent faster or
/// slower from hour to hour.
///
/// Each renderer is tested as a whole, from three renders: the mean of the logarithms of the ratios, by
/// Student's test, less that of all other renderers if these have six renders, so that a slower machine is no
/// slower renderer. It has not changed if the others have moved more.
///
/// Each render is tested against the other renders of its renderer, from six: its own logarithm against their
/// mean and scatter. Times have outliers, so no more than eight degrees of freedom are taken.
///
/// Renders on other kinds of machines, with other samples or other threads are left out.
std::vector<Candidate> time_candidates(const RunPair& pair);

}  // namespace orbs::history
