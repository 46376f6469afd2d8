#include "report/short_reason.h"

#include "base/short_sentence.h"

#include <algorithm>

namespace orbs::report {

std::string short_reason(const std::string& reason, int width) {
  constexpr int kMostColumns = 100;  // longer lines are hard to read on wide terminals, too
  constexpr int kIndent = 6;         // of text_table, below the names of the target
  constexpr int kLeast = 20;
  const int room = width == 0 ? kMostColumns : std::clamp(width - kIndent, kLeast, kMostColumns);
  return short_sentence(reason, static_cast<std::size_t>(room));
}

std::string line_reason(results::Verdict verdict,
                        results::Expectation expectation,
                        const std::string& reason,
                        int width) {
  using results::Verdict;
  if (verdict != Verdict::Fail && verdict != Verdict::Inconclusive) return reason;
  if (expectation != results::Expectation::News) return short_reason(reason, width);
  // What is news comes first, and names the entry to look at.
  const auto news = reason.find("; ");
  if (news == std::string::npos) return reason;
  return reason.substr(0, news + 2) + short_reason(reason.substr(news + 2), width);
}

}  // namespace orbs::report
