#pragma once

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
inline bool is_absent(const VersionRange& range) { return range.text.empty(); }

/// Whether the first number of `version` ("Blender 3.4.1") lies in the range; parts that one of the two lacks
/// count as 0, so 3.4 equals 3.4.0. A text without a number lies in no range that has a bound.
bool is_in_range(const VersionRange& range, const std::string& version);

/// The range that holds this version alone, "=3.4.1"; without bounds where the text has no number that stands
/// by itself, as in the name of a commit.
VersionRange range_of_version(const std::string& version);

}  // namespace orbs::registry
