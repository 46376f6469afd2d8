#pragma once

#include "history/compare_runs.h"
#include "results/record.h"

#include <string>
#include <vector>

namespace orbs::history {

/// The variants of one renderer in a run, each compared with the first of them by verdicts and by numbers
/// beyond chance, as runs are, see kFalseAlarms. Times are not compared.
std::vector<RunComparison> compare_variants(const results::RunRecord& run);

/// A line for each comparison, and below it what differs, the worst first: "gpu against cpu: 41 targets, the
/// same but for noise". "" if there is none.
std::string variants_text(const std::vector<RunComparison>& comparisons);

}  // namespace orbs::history
