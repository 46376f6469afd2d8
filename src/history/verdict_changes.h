#pragma once

#include "history/change.h"
#include "history/pair_runs.h"

#include <vector>

namespace orbs::history {

/// Targets whose state differs. It is worse if it counts as a failure now and did not before, if it is a
/// worse failure, or if a pass became unsupported; a change between pass and inconclusive is neither, since
/// noise decides there. What was skipped in one of the runs is not compared.
std::vector<Change> verdict_changes(const RunPair& pair);

}  // namespace orbs::history
