#pragma once

#include "registry/case.h"
#include "registry/configuration.h"
#include "results/record.h"
#include "run/plan/plan.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// Failures that the configuration expects.
namespace orbs::run {

/// How many times as large the error of a known failure may become before it is news. Where the number has an
/// interval, all of the interval must lie beyond. An error of a PSNR is the mean squared error, so twice is 3
/// dB; of a number between two limits its distance from their middle; of one with a least value only, such as
/// SSIM, its distance from 1.
inline constexpr double kMuchWorse = 2;

/// InputError with file and line for an entry whose verdict no failure can have, or whose scenes are targets
/// of no suite. `cases`: those of the plan's suite, chosen or not.
void refuse_unknown_expected(const registry::Configuration& configuration,
                             const registry::Suite& suite,
                             const std::vector<registry::Case>& cases);

/// Versions by name of the renderer.
using Versions = std::map<std::string, std::string>;

/// Compares the verdicts of targets with what is expected of them in these versions of their renderers, and
/// notes the result in each. `targets` holds all records of each target: one that several cases judge passes
/// unexpectedly only if it passes for all of them.
void mark_expected(const std::vector<registry::ExpectedFailure>& expected,
                   const Versions& versions,
                   std::vector<results::TargetRecord>& targets);

/// By the versions that the run has recorded of its renderers.
void mark_expected(const std::vector<registry::ExpectedFailure>& expected, results::RunRecord& run);

/// Entries for all failures of the run that count: what `--accept-failures` writes. Skipped targets and
/// missing references are left out, since they say nothing of the renderer.
std::vector<registry::ExpectedFailure> accepted_failures(const results::RunRecord& run,
                                                         const std::string& reason);

/// Writes an entry under "expected" in the file `configuration` for each failure of the run that counts,
/// with `reason`, and leaves every other byte as it is. The new text is read as any configuration before it
/// takes the place of the old one. Then compares `run` with the new entries and writes its results.json anew.
/// Returns the number of entries. InputError when the file cannot take them: it is untouched then.
std::size_t accept_failures(const std::filesystem::path& configuration,
                            const std::string& reason,
                            results::RunRecord& run);

}  // namespace orbs::run
