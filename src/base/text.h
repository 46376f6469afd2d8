#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace orbs {

std::string_view trim(std::string_view text);

/// Splits at each separator and keeps empty parts. The empty text has one empty part.
std::vector<std::string> split(std::string_view text, char separator);

/// Splits at blanks, tabs and line ends, and leaves out empty parts.
std::vector<std::string> words_of(std::string_view text);

/// Reads the whole text as a number in any locale. std::nullopt if any part of it is no number.
std::optional<double> to_number(std::string_view text);
std::optional<long long> to_integer(std::string_view text);

/// " (did you mean 'x'?)" for the nearest candidate within two edits, "" if there is none. Words of more than
/// 64 characters are not compared, because that takes quadratic time.
std::string closest(const std::string& word, const std::set<std::string>& candidates);

/// Whether the whole text matches a pattern as of a shell: '*' is any run, '?' any one character.
bool glob_match(std::string_view pattern, std::string_view text);

/// Length in bytes of the UTF-8 sequence that starts `text`. 0 if there is none by RFC 3629, which excludes
/// overlong forms, surrogates and values above U+10FFFF.
std::size_t utf8_length(std::string_view text);

/// Text of strangers (titles, names, reasons, output of programs) as a terminal and a file of text can take
/// it: U+FFFD replaces bytes that are no UTF-8, of control characters other than tabs and line
/// ends, of a carriage return that ends no line, and of the characters that reorder text (bidirectional
/// controls, Unicode Standard Annex 9), which make a line look like another one.
std::string clean_text(std::string_view text);

/// clean_text on one line: line ends and tabs become blanks.
std::string clean_line(std::string_view text);

/// Names that become words of commands and names of files: file systems take 255 bytes, and endings follow.
constexpr std::size_t kMostNameCharacters = 100;

/// Of ASCII, independent of the locale.
bool is_letter_or_digit(char c);

/// At most kMostNameCharacters letters, digits and characters of `marks`, a letter or a digit first: leads to
/// no other folder, and is no option of a command.
bool is_plain_name(std::string_view name, std::string_view marks = "-_");

/// Quotes `words` as a command line that a POSIX shell splits into the same words.
std::string shell_text(const std::vector<std::string>& words);

/// A line for a POSIX shell that runs `argv` with exactly the variables NAME=value of `environment`.
std::string shell_command(std::vector<std::string> environment, const std::vector<std::string>& argv);

}  // namespace orbs
