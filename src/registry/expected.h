#pragma once

#include "json/fields.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace orbs::registry {

/// Comparisons that a version must all meet, as they are written: "<4.0", ">=3.4 <4". Without any, every
/// version is in the range.
struct VersionRange {
  struct Bound {
    std::string comparison;  // "<", "<=", "=", ">=" or ">"
    std::vector<int> version;
  };
  std::string text{};
  std::vector<Bound> bounds{};
};

/// InputError saying what can be read if the text is no range.
VersionRange parse_version_range(const std::string& text);

inline const std::string& to_text(const VersionRange& range) { return range.text; }
inline void from_text(const std::string& text, VersionRange& range) { range = parse_version_range(text); }

/// Whether the first number of `version` ("Blender 3.4.1") lies in the range; parts that one of the two lacks
/// count as 0, so 3.4 equals 3.4.0. A text without a number lies in no range that has a bound.
bool is_in_range(const VersionRange& range, const std::string& version);

/// A failure that is known: an entry under "expected" in configuration.json. It is named in every report and
/// does not make a run fail.
struct ExpectedFailure {
  std::string place{};     // file:line of the entry, for messages; "" when it comes from no file
  std::string renderer{};  // comma-separated patterns
  VersionRange version{};  // of the renderer
  std::string scene{};     // comma-separated patterns: names of targets
  std::string verdict{};   // "fail", "crash", ...
  std::string reason{};
  /// The checks that were not met with their numbers, as they were when the failure was accepted; a check on
  /// no number has none. Empty: any failure is expected.
  std::map<std::string, std::optional<double>> measure{};
};

template <class Visitor, json::RecordOf<ExpectedFailure> Record>
void fields(Visitor& visit, Record& failure) {
  visit.required("renderer", failure.renderer, {.help = "Names or patterns, separated by commas"});
  visit("version", failure.version,
        {.help = "Comparisons with the version of the renderer that must all hold, such as `>=3.4 <4`",
         .unset = "every version"});
  visit.required("scene", failure.scene,
                 {.help = "Names or patterns of scenes and differences, separated by commas"});
  visit.required("verdict", failure.verdict, {.help = "The verdict that is expected"});
  visit.required("reason", failure.reason, {.help = "Why the failure is accepted"});
  visit("measure", failure.measure,
        {.help = "The failed checks with their numbers, null for a check on no number",
         .unset = "whatever fails is expected"});
}

/// Checks the entries that were read from "expected" of the object `in`, and notes their places. InputError
/// with file, line and key, also for a renderer that is none of `renderers`. Verdicts and scenes are checked
/// where they are known.
void check_expected(json::ObjectReader& in,
                    const std::vector<std::string>& renderers,
                    std::vector<ExpectedFailure>& expected);

/// The entry that counts for a target of a renderer in this version: the last one that matches. nullptr if
/// there is none.
const ExpectedFailure* find_expected(const std::vector<ExpectedFailure>& expected,
                                     const std::string& renderer,
                                     const std::string& version,
                                     const std::string& target);

/// The text of a configuration file with these entries under "expected". An entry that names the same
/// renderer and scene, without patterns, is replaced and keeps its version; every other byte stays as it is.
std::string with_expected(const std::string& text,
                          const std::vector<ExpectedFailure>& present,
                          const std::vector<ExpectedFailure>& added);

}  // namespace orbs::registry
