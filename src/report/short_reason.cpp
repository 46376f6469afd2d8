#include "report/short_reason.h"

#include "base/text_table.h"

#include <string_view>

namespace orbs::report {

namespace {

constexpr std::size_t kMostCharacters = 100;

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

// Cut between words.
std::string cut(const std::string& text) {
  if (display_width(text) <= kMostCharacters) return text;
  const auto end = text.rfind(' ', kMostCharacters);
  return text.substr(0, end == std::string::npos ? text.size() : end);
}

}  // namespace

std::string short_reason(const std::string& reason) {
  auto text = cut(first_part(reason));
  while (text.ends_with(',') || text.ends_with(':') || text.ends_with(' ')) text.pop_back();
  return text == reason ? reason : text + " ...";
}

std::string line_reason(results::Verdict verdict,
                        results::Expectation expectation,
                        const std::string& reason) {
  using results::Verdict;
  if (verdict != Verdict::Fail && verdict != Verdict::Inconclusive) return reason;
  if (expectation != results::Expectation::News) return short_reason(reason);
  // What is news comes first, and names the entry to look at.
  const auto news = reason.find("; ");
  if (news == std::string::npos) return reason;
  return reason.substr(0, news + 2) + short_reason(reason.substr(news + 2));
}

}  // namespace orbs::report
