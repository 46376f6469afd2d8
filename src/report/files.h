#pragma once

#include "base/files.h"
#include "results/record.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace orbs::report {

/// CSV (RFC 4180) in long form: one row per target and renderer.
std::string results_csv(const results::RunRecord& run);

/// JUnit XML: a test suite per renderer, a test case per requirement. Unsupported and skipped targets count
/// as skipped; crashes, timeouts and missing images as errors; wrong images as failures.
std::string junit_xml(const results::RunRecord& run);

/// `text` for an XML 1.0 attribute or element: the five special characters escaped, control characters that
/// XML cannot hold and bytes that are not UTF-8 replaced by U+FFFD.
std::string xml_text(std::string_view text);

/// Writes results.csv and junit.xml into `folder`.
inline void write_reports(const results::RunRecord& run, const std::filesystem::path& folder) {
  write_file(folder / "results.csv", results_csv(run));
  write_file(folder / "junit.xml", junit_xml(run));
}

}  // namespace orbs::report
