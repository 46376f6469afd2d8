#pragma once

#include "base/files.h"
#include "report/junit.h"
#include "results/record.h"

#include <filesystem>
#include <string>

namespace orbs::report {

/// CSV (RFC 4180) in long form: one row per target and renderer.
std::string results_csv(const results::RunRecord& run);

/// Writes results.csv and junit.xml into `folder`.
inline void write_reports(const results::RunRecord& run, const std::filesystem::path& folder) {
  write_file(folder / "results.csv", results_csv(run));
  write_file(folder / "junit.xml", junit_xml(run));
}

}  // namespace orbs::report
