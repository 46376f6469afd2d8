#pragma once

#include "registry/case.h"
#include "registry/configuration.h"
#include "results/record.h"
#include "run/plan/plan.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Failures that the configuration expects.
namespace orbs::run {

/// InputError with file and line for an entry whose verdict no failure can have, or whose scenes are targets
/// of no suite, or not of the one that it names. `cases`: those of the plan's suite, chosen or not.
void refuse_unknown_expected(const registry::Configuration& configuration,
                             const registry::Suite& suite,
                             const std::vector<registry::Case>& cases);

/// Versions by name of the renderer.
using Versions = std::map<std::string, std::string>;

/// Compares the verdicts of targets with what is expected of them in a run of this kind and in these versions
/// of their renderers, and notes the result in each; numbers by compare_with_accepted. A failure that is
/// better than the accepted one stays known, and says so. One whose entry has expired is not known, and says
/// so. `targets` holds all records of each target: one that several cases judge passes unexpectedly only if
/// it passes for all of them.
void mark_expected(const std::vector<registry::ExpectedFailure>& expected,
                   const registry::RunKind& run,
                   const Versions& versions,
                   std::vector<results::TargetRecord>& targets);

/// By what the run has recorded of itself and of its renderers.
void mark_expected(const std::vector<registry::ExpectedFailure>& expected, results::RunRecord& run);

/// Entries for all failures of the run that count, of its suite and size: what `--accept-failures` writes.
/// Known failures that are better than their entry among `present` have one, too, with the reason of that
/// entry. Skipped targets and missing references are left out, since they say nothing of the renderer.
std::vector<registry::ExpectedFailure> accepted_failures(
    const results::RunRecord& run,
    const std::vector<registry::ExpectedFailure>& present,
    const std::string& reason);

struct AcceptSettings {
  std::string reason;
  std::optional<registry::Day> until{};  // without one, an entry that is replaced keeps its own
};

/// What accepting failures makes of the user's own file.
struct Acceptance {
  std::string before;
  std::string after;                                // the same text if nothing is accepted
  std::size_t entries = 0;                          // that are new or replaced
  std::vector<registry::ExpectedFailure> expected;  // of the whole configuration afterwards
};

/// The text of the user's own file in `configuration` as it is now, and with an entry under "expected" for
/// each failure of the run that counts; every other byte stays. Writes nothing. InputError when the file
/// cannot take them: the new text is read as any configuration.
Acceptance acceptance_of(const registry::Configuration& configuration,
                         const AcceptSettings& settings,
                         const results::RunRecord& run);

/// Writes an entry under "expected" in the user's own file of `configuration` for each failure of the run
/// that counts, with `reason`: acceptance_of. Then compares `run` with the new entries and
/// writes its results.json anew. Returns the number of entries. InputError when the file cannot take them: it
/// is untouched then.
std::size_t accept_failures(const registry::Configuration& configuration,
                            const std::string& reason,
                            results::RunRecord& run);

}  // namespace orbs::run
