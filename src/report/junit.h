#pragma once

#include "results/record.h"

#include <string>
#include <string_view>

namespace orbs::report {

/// JUnit XML: a test suite per renderer, a test case per requirement. Unsupported and skipped targets count
/// as skipped; crashes, timeouts and missing images as errors; wrong images as failures.
std::string junit_xml(const results::RunRecord& run);

/// `text` for an XML 1.0 attribute or element: the five special characters escaped, control characters that
/// XML cannot hold and bytes that are not UTF-8 replaced by U+FFFD.
std::string xml_text(std::string_view text);

}  // namespace orbs::report
