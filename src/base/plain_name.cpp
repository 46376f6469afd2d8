#include "base/plain_name.h"

#include <algorithm>

namespace orbs {

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool is_plain_name(std::string_view name, std::string_view marks) {
  const auto is_plain = [&](char c) {
    return is_letter_or_digit(c) || marks.find(c) != std::string_view::npos;
  };
  return !name.empty() && name.size() <= kMostNameCharacters && is_letter_or_digit(name.front()) &&
         std::all_of(name.begin(), name.end(), is_plain);
}

}  // namespace orbs
