#pragma once

#include "base/terminal.h"
#include "history/compare_runs.h"

#include <string>
#include <vector>

/// The comparison of two runs, for people and programs.
namespace orbs::history {

/// A line on what was compared, a table of all changes, and what was not compared.
std::string comparison_text(const RunComparison& comparison, const TerminalStyle& style);

/// The same for a pull request.
std::string comparison_markdown(const RunComparison& comparison);

/// The same for programs (format "orbs-comparison/1").
std::string comparison_json(const RunComparison& comparison);

/// A line for each comparison, and below it what differs, the worst first: "gpu against cpu: 41 targets, the
/// same but for noise". "" if there is none.
std::string variants_text(const std::vector<RunComparison>& comparisons);

}  // namespace orbs::history
