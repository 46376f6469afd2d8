#pragma once

#include "history/change.h"
#include "history/pair_runs.h"
#include "results/record.h"

#include <cstddef>
#include <string>
#include <vector>

namespace orbs::history {

struct RunComparison {
  std::string before;  // names of the runs
  std::string after;
  std::size_t targets = 0;         // that both have
  std::size_t tests = 0;           // of numbers
  std::vector<Change> changes;     // the worst first
  std::vector<std::string> notes;  // what was not compared, and why
};

/// Compares two runs target by target: verdicts, and numbers that changed beyond chance, see kFalseAlarms.
/// InputError if nothing can be compared.
RunComparison compare_runs(const results::RunRecord& before, const results::RunRecord& after);

/// The comparison of pairs of targets by what changed in verdicts, and by tests of up to three kinds of
/// numbers, which share kFalseAlarms evenly.
RunComparison compare_pairs(const RunPair& pair,
                            std::vector<Change> verdicts,
                            std::vector<std::vector<Candidate>> numbers);

/// 1 if anything is worse, else 0.
int exit_status(const RunComparison& comparison);

/// A line on what was compared, a table of all changes, and what was not compared.
std::string comparison_text(const RunComparison& comparison, int width);

/// The same for a pull request.
std::string comparison_markdown(const RunComparison& comparison);

/// The same for programs (format "orbs-comparison/1").
std::string comparison_json(const RunComparison& comparison);

/// The variants of one renderer in a run, each compared with the first of them by verdicts and by numbers
/// beyond chance, as runs are, see kFalseAlarms. Times are not compared.
std::vector<RunComparison> compare_variants(const results::RunRecord& run);

/// A line for each comparison, and below it what differs, the worst first: "gpu against cpu: 41 targets, the
/// same but for noise". "" if there is none.
std::string variants_text(const std::vector<RunComparison>& comparisons);

}  // namespace orbs::history
