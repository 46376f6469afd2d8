#pragma once

#include "json/fields.h"
#include "registry/day.h"
#include "registry/image_size.h"
#include "registry/version_range.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace orbs::registry {

/// A failure that is known: an entry under "expected" in configuration.json. It is named in every report and
/// does not make a run fail.
struct ExpectedFailure {
  std::string place{};     // file:line of the entry, for messages; "" when it comes from no file
  std::string renderer{};  // comma-separated patterns
  VersionRange version{};  // of the renderer
  std::string scene{};     // comma-separated patterns: names of targets
  std::optional<std::string> suite{};
  std::optional<SizeDivisor> size{};
  std::string verdict{};  // "fail", "crash", ...
  std::string reason{};
  std::optional<Day> until{};  // the last day on which it counts
  /// The checks that were not met with their numbers, sign and all, as they were when the failure was
  /// accepted; a check on no number has none. Empty: any failure is expected.
  std::map<std::string, std::optional<double>> measure{};
  /// By which share two runs differ though nothing has changed.
  std::optional<double> tolerance{};
};

template <class Visitor, json::RecordOf<ExpectedFailure> Record>
void fields(Visitor& visit, Record& failure) {
  visit.required("renderer", failure.renderer, {.help = "Names or patterns, separated by commas"});
  visit("version", failure.version,
        {.help = "Comparisons with the version of the renderer that must all hold, such as `>=3.4 <4`",
         .unset = "every version"});
  visit.required("scene", failure.scene,
                 {.help = "Names or patterns of scenes and differences, separated by commas"});
  visit("suite", failure.suite, {.help = "The suite of the scenes", .unset = "every suite"});
  visit("size", failure.size, {.help = "The size of the run", .unset = "every size"});
  visit.required("verdict", failure.verdict, {.help = "The verdict that is expected"});
  visit.required("reason", failure.reason, {.help = "Why the failure is accepted"});
  visit("until", failure.until,
        {.help =
             "The last day on which it is accepted, such as `2026-11-25`; the day of a run is that on which "
             "it was started",
         .unset = "it does not expire"});
  visit("measure", failure.measure,
        {.help = "The failed checks with their numbers, null for a check on no number",
         .unset = "any failure is expected"});
  visit("tolerance", failure.tolerance,
        {.help = "The share by which an error may be larger than accepted: more for a renderer of which two "
                 "runs differ, as the radiosity of POV-Ray's threads",
         .range = json::kPositive,
         .unset = "0.05"});
}

/// Checks the entries that were read from "expected" of the object `in`, and notes their places. InputError
/// with file, line and key, also for a renderer or a suite that is none of these. Verdicts and scenes are
/// checked where they are known.
void check_expected(json::ObjectReader& in,
                    const std::vector<std::string>& renderers,
                    const std::vector<std::string>& suites,
                    std::vector<ExpectedFailure>& expected);

/// The entries that one file holds under "expected", in its order. They are not checked.
std::vector<ExpectedFailure> expected_of_text(const std::filesystem::path& file, const std::string& text);

/// What of a run decides whether an entry is for it.
struct RunKind {
  std::string suite;
  SizeDivisor size = FullSize;
  std::string day;      // on which it was started, "2026-11-25"
  bool strict = false;  // it accepts no remarks that are not expected
};

/// The entries of a target. Both are nullptr if there is none.
struct FoundExpected {
  const ExpectedFailure* counting = nullptr;  // the last one that matches and has not expired
  const ExpectedFailure* expired = nullptr;   // if none counts: the last one that matches
};

FoundExpected find_expected(const std::vector<ExpectedFailure>& expected,
                            const std::string& renderer,
                            const std::string& version,
                            const std::string& target,
                            const RunKind& run);

/// The text of a configuration file with these entries under "expected". An entry that names the same
/// renderer, scene, suite and size, without patterns, is replaced and keeps its version, and, if the new
/// one names none, its last day unless it is before `day`; every other byte stays as it is.
std::string with_expected(const std::string& text,
                          const std::vector<ExpectedFailure>& present,
                          const std::vector<ExpectedFailure>& added,
                          const std::string& day);

}  // namespace orbs::registry
