#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

/// What is written to the terminal. Titles, names and reasons come from files of strangers, who could move
/// the cursor, rename the window or hide lines with them.
namespace orbs {

/// clean_text, except that the colours of our own tables stay.
std::string terminal_text(std::string_view text);

/// Writes terminal_text of the formatted text. All output of the programs for people goes through here. JSON
/// does not: it escapes control characters, and must arrive as it is.
template <typename... Args>
void print_clean(std::FILE* file, fmt::format_string<Args...> format, Args&&... args) {
  fmt::print(file, "{}", terminal_text(fmt::format(format, std::forward<Args>(args)...)));
}

template <typename... Args>
void print_clean(fmt::format_string<Args...> format, Args&&... args) {
  print_clean(stdout, format, std::forward<Args>(args)...);
}

/// Writes the text as it is: for JSON, and for our own text that moves the cursor.
void print_raw(std::FILE* file, std::string_view text);

/// Columns that lines on `descriptor` may take before the terminal breaks them: COLUMNS if it is set to a
/// number from 20, else the width of the terminal; 0, no limit, for what is no terminal.
int terminal_width(int descriptor);

/// How lines for people look.
struct TerminalStyle {
  bool colour = false;  // ANSI escapes
  int width = 0;        // columns of the terminal, see terminal_width; 0: no limit
};

/// Colour if `descriptor` is a terminal that supports it and the user did not set NO_COLOR
/// (https://no-color.org), and the width of that terminal.
TerminalStyle terminal_style(int descriptor);

/// The text in this colour, or as it is where the style has no colour or the colour is empty.
std::string painted(std::string_view text, std::string_view colour, const TerminalStyle& style);

namespace colour {
inline constexpr std::string_view kGreen = "\x1b[32m";
inline constexpr std::string_view kRed = "\x1b[31m";
inline constexpr std::string_view kYellow = "\x1b[33m";
inline constexpr std::string_view kFaint = "\x1b[2m";
inline constexpr std::string_view kNone = "\x1b[0m";
}  // namespace colour

}  // namespace orbs
