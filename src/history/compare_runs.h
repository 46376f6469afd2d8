#pragma once

#include "history/change.h"
#include "history/pair_runs.h"
#include "results/record.h"

#include <cstddef>
#include <string>
#include <vector>

namespace orbs::history {

/// Why nothing can be said of a target.
enum class Loss { Vanished, NotRendered, NotComparable };

/// "vanished", "not rendered", "no longer comparable".
std::string loss_name(Loss loss);

/// A target of the earlier run that cannot be compared. NotComparable: its numbers, since its reference is
/// another one; its verdicts are compared all the same.
struct LostTarget {
  Loss loss;
  std::string target;  // "cycles 101"
  std::string reason;  // "" for one that vanished
};

struct RunComparison {
  std::string before;  // names of the runs
  std::string after;
  std::size_t targets = 0;      // that both have
  std::size_t tests = 0;        // of numbers
  std::vector<Change> changes;  // the worst first
  std::vector<LostTarget> lost;
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

/// The run as if it had this renderer alone, under the name `as`: two renderers are compared like two runs.
results::RunRecord with_renderer(results::RunRecord run, const std::string& renderer, const std::string& as);

/// 1 if anything is worse or lost, else 0.
int exit_status(const RunComparison& comparison);

/// How many of its changes go into that direction.
std::size_t count_of(const RunComparison& comparison, Direction direction);

/// The variants of one renderer in a run, each compared with the first of them by verdicts and by numbers
/// beyond chance, as runs are, see kFalseAlarms. Times are not compared.
std::vector<RunComparison> compare_variants(const results::RunRecord& run);

}  // namespace orbs::history
