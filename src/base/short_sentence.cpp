#include "base/short_sentence.h"

#include "base/text_table.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace orbs {

namespace {

constexpr std::string_view kLeftOut = " ...";

// "(2, -0.5)", which a sentence cannot do without.
bool is_point(std::string_view bracket) {
  return bracket.find(',') != std::string_view::npos &&
         bracket.find_first_not_of("(0123456789-., ") == std::string_view::npos;
}

// Without what stands in parentheses, but for points, and up to the first "; " outside of them.
std::string first_part(const std::string& reason) {
  std::string out;
  int depth = 0;
  for (std::size_t i = 0; i < reason.size(); ++i) {
    const char c = reason[i];
    const auto end = reason.find(')', i);
    if (c == '(' && depth == 0 && end != std::string::npos &&
        is_point(std::string_view(reason).substr(i, end - i))) {
      out += reason.substr(i, end + 1 - i);
      i = end;
    } else if (c == '(') {
      if (depth++ == 0 && out.ends_with(' ')) out.pop_back();
    } else if (c == ')' && depth > 0) {
      --depth;
    } else if (depth == 0) {
      if (c == ';') break;
      out += c;
    }
  }
  return depth == 0 ? out : reason;
}

// A line must not end with a number whose unit or with a word whose object was cut off.
bool needs_next_word(std::string_view word) {
  constexpr std::array<std::string_view, 22> kLeading{
      "a",  "an",  "the", "of", "by",   "at",   "to",   "in",  "is",   "are", "than",
      "on", "and", "or",  "as", "that", "with", "over", "not", "from", "no",  "for"};
  if (std::find(kLeading.begin(), kLeading.end(), word) != kLeading.end()) return true;
  return !word.empty() && word.find_first_not_of("0123456789.+-,e") == std::string_view::npos &&
         word.find_first_of("0123456789") != std::string_view::npos;
}

// Cut between words: after the last comma or colon of the second half, else where a phrase ends.
std::string cut(const std::string& text, std::size_t most) {
  if (display_width(text) <= most) return text;
  const auto lines = wrapped(text, std::max<std::size_t>(most, 1));
  auto line = lines.front();
  const auto clause = line.find_last_of(",:");
  if (clause != std::string::npos && clause >= line.size() / 2 && line.compare(clause + 1, 1, " ") == 0)
    return line.substr(0, clause);
  for (auto space = line.rfind(' '); space != std::string::npos && needs_next_word(line.substr(space + 1));
       space = line.rfind(' '))
    line.erase(space);
  return line;
}

}  // namespace

std::string short_sentence(const std::string& text, std::size_t most) {
  const auto first = first_part(text);
  if (first == text && display_width(text) <= most) return text;
  auto out = cut(first, most - std::min(most, kLeftOut.size()));
  while (out.ends_with(',') || out.ends_with(':') || out.ends_with(' ')) out.pop_back();
  return out == text ? text : out + std::string(kLeftOut);
}

}  // namespace orbs
