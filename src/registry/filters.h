#pragma once

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace orbs::registry {

/// The patterns of a comma-separated list, trimmed, empty ones dropped.
inline std::vector<std::string> patterns_of(std::string_view list) {
  std::vector<std::string> patterns;
  for (const auto& item : split(list, ','))
    if (const auto pattern = trim(item); !pattern.empty()) patterns.emplace_back(pattern);
  return patterns;
}

/// True when one of the patterns ('*', '?' as in a shell) matches the whole name.
inline bool matches_any(const std::vector<std::string>& patterns, std::string_view name) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const auto& pattern) { return glob_match(pattern, name); });
}

/// Those of `names` that the comma-separated patterns choose, in the order of `names`. InputError, with the
/// nearest name, when the list is empty or one pattern of it chooses nothing: a typo must not quietly test
/// less. `what` is the word for the message ("scene").
inline std::vector<std::string> select_names(const std::vector<std::string>& names,
                                             std::string_view list,
                                             const std::string& what) {
  const auto patterns = patterns_of(list);
  if (patterns.empty()) throw InputError(fmt::format("no {} is chosen: '{}' holds no name", what, list));
  const std::set<std::string> known(names.begin(), names.end());
  for (const auto& pattern : patterns)
    if (std::none_of(names.begin(), names.end(), [&](const auto& name) { return glob_match(pattern, name); }))
      throw InputError(fmt::format("no {} matches '{}'{}; 'orbs list {}s' shows what there is", what, pattern,
                                   closest(pattern, known), what));
  std::vector<std::string> chosen;
  for (const auto& name : names)
    if (matches_any(patterns, name)) chosen.push_back(name);
  return chosen;
}

}  // namespace orbs::registry
