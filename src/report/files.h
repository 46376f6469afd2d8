#pragma once

#include "results/record.h"

#include <filesystem>

namespace orbs::report {

/// Writes results.csv and junit.xml into `folder`.
void write_reports(const results::RunRecord& run, const std::filesystem::path& folder);

}  // namespace orbs::report
