#pragma once

#include <string_view>

namespace orbs {

/// Names that become words of commands and names of files: file systems take 255 bytes, and endings follow.
constexpr std::size_t kMostNameCharacters = 100;

/// Of ASCII, independent of the locale.
bool is_letter_or_digit(char c);

/// At most kMostNameCharacters letters, digits and characters of `marks`, a letter or a digit first: leads to
/// no other folder, and is no option of a command.
bool is_plain_name(std::string_view name, std::string_view marks = "-_");

}  // namespace orbs
