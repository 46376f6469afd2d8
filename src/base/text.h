#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace orbs {

std::string_view trim(std::string_view text);

/// The parts between separators, empty ones included; the empty text has one empty part.
std::vector<std::string> split(std::string_view text, char separator);

/// The parts between blanks, tabs and line ends, of which none is empty.
std::vector<std::string> words_of(std::string_view text);

/// The whole text as a number, independent of the locale; nothing when a part of it is no number.
std::optional<double> to_number(std::string_view text);
std::optional<long long> to_integer(std::string_view text);

/// " (did you mean 'x'?)" for the nearest candidate within two edits, else ""; also "" for words of more than
/// 64 characters.
std::string closest(const std::string& word, const std::set<std::string>& candidates);

/// Shell-like pattern: '*' any run, '?' any one character; the whole text must match.
bool glob_match(std::string_view pattern, std::string_view text);

/// Length of the UTF-8 sequence that starts `text`, 0 when there is none: RFC 3629, without overlong forms,
/// surrogates and what lies above U+10FFFF.
std::size_t utf8_length(std::string_view text);

/// What a terminal, a table and a file of text can take: U+FFFD stands in place of bytes that are no UTF-8
/// and of control characters other than tabs and line ends.
std::string clean_text(std::string_view text);

}  // namespace orbs
