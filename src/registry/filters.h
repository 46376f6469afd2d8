#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace orbs::registry {

/// The patterns of a comma-separated list, trimmed, empty ones dropped.
std::vector<std::string> patterns_of(std::string_view list);

/// True when one of the patterns ('*', '?' as in a shell) matches the whole name.
bool matches_any(const std::vector<std::string>& patterns, std::string_view name);

/// Those of `names` that the comma-separated patterns choose, in the order of `names`. InputError, with the
/// nearest name, when the list is empty or one pattern of it chooses nothing: a typo must not quietly test
/// less. `what` is the word for the message ("scene").
std::vector<std::string> select_names(const std::vector<std::string>& names,
                                      std::string_view list,
                                      const std::string& what);

}  // namespace orbs::registry
