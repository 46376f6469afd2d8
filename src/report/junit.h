#pragma once

#include "results/record.h"

#include <string>
#include <string_view>

namespace orbs::report {

/// JUnit XML: a test suite for each renderer and requirement, "orbs.cycles.M2", and in it a test case for
/// each target, so that a CI server shows the history of a scene. Its class is that of the suite, its name
/// case and target. Unsupported and skipped targets and known failures count as skipped; crashes, timeouts
/// and missing images as errors; other failures as failures. These elements have the state as their type,
/// state and reason as their message, and in their body the reason, the diagnosis, remarks and the command.
///
/// It holds what the schema of Jenkins allows (xunit-plugin, junit-10.xsd), which has no properties in a test
/// case and no number of skipped tests of all suites. GitLab (lib/gitlab/ci/parsers/test/junit.rb) and
/// dorny/test-reporter (java-junit-parser.ts) read the body alone of failures and errors.
std::string junit_xml(const results::RunRecord& run);

/// `text` for an XML 1.0 attribute or element: the five special characters escaped, control characters that
/// XML cannot hold and bytes that are not UTF-8 replaced by U+FFFD.
std::string xml_text(std::string_view text);

}  // namespace orbs::report
