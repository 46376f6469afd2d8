#pragma once

#include <cstddef>
#include <string>

namespace orbs {

/// One short sentence of a text: its first part up to "; ", without what stands in parentheses, but for
/// points, in at most `most` columns. A longer one ends with a phrase, and no number is cut from its unit.
/// The sentence ends with " ..." where something was left out.
std::string short_sentence(const std::string& text, std::size_t most);

}  // namespace orbs
