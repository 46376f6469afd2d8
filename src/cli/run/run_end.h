#pragma once

#include "cli/program.h"
#include "registry/run_settings.h"
#include "results/record.h"

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::cli {

/// Whether the target fails the run.
bool fails_run(const results::TargetRecord& target);

/// Whether the run was ended because as many targets failed as --maxfail allows.
bool ended_by_failures(const results::RunRecord& record, const registry::RunSettings& settings);

/// What orbs run prints of a run that has ended, as its settings want it: the table or only counts, the
/// slowest renders, the folder and what can be done next.
void print_end(const results::RunRecord& record,
               const registry::RunSettings& settings,
               const std::filesystem::path& folder,
               const Program& program);

/// One line for each target whose verdict differs between the runs, "flaky"; the counts of all others. The
/// runs differ by their seeds.
std::string repeats_text(const std::vector<results::RunRecord>& runs, int width);

}  // namespace orbs::cli
