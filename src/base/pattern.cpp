#include "base/pattern.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

namespace orbs {

namespace {

// The GNU C library recurses by nested group and copies what a bound "{m,n}" repeats: 20,000 groups overflow
// its stack, and three bounds of 255 inside each other never end.
constexpr std::size_t kDeepest = 50;
constexpr std::size_t kMostStates = 10'000;

// Index behind the bracket expression "[...]" that begins at `at`; the text's end where it does not close.
std::size_t end_of_bracket(const std::string& text, std::size_t at) {
  ++at;
  if (at < text.size() && text[at] == '^') ++at;
  if (at < text.size() && text[at] == ']') ++at;  // a first ']' stands for itself
  while (at < text.size() && text[at] != ']') {
    const bool is_class = text[at] == '[' && at + 1 < text.size() &&
                          std::string_view(".:=").find(text[at + 1]) != std::string::npos;
    const auto close = is_class ? text.find(std::string{text[at + 1], ']'}, at + 2) : std::string::npos;
    at = close == std::string::npos ? at + 1 : close + 2;
  }
  return std::min(at + 1, text.size());
}

// The largest number between the braces of the bound that begins at `at`; 1 where there is none.
std::size_t largest_bound(const std::string& text, std::size_t at) {
  std::size_t largest = 1;
  std::size_t number = 0;
  for (++at; at < text.size() && text[at] != '}'; ++at) {
    const bool is_digit = text[at] >= '0' && text[at] <= '9';
    number = is_digit
                 ? std::min<std::size_t>(10 * number + static_cast<std::size_t>(text[at] - '0'), kMostStates)
                 : 0;
    largest = std::max(largest, number);
  }
  return largest;
}

// Why the expression is too large to be compiled, counted in single characters with every bound written out;
// "" when it is not.
std::string size_problem(const std::string& text) {
  std::vector<std::size_t> groups{0};  // states of each open group
  std::size_t last = 0;                // of what a bound behind it would repeat
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::size_t states = 1;
    switch (text[at]) {
      case '(':
        groups.push_back(0);
        if (groups.size() > kDeepest + 1) return fmt::format("it nests more than {} groups", kDeepest);
        continue;
      case ')':
        if (groups.size() == 1) break;
        states += groups.back();
        groups.pop_back();
        break;
      case '{': {
        const auto bound = largest_bound(text, at);
        groups.back() += last * (bound - 1);
        last *= bound;
        states = 0;
        at = std::min(text.find('}', at), text.size() - 1);
        break;
      }
      case '[':
        at = end_of_bracket(text, at) - 1;
        break;
      case '\\':
        if (++at < text.size() && text[at] >= '1' && text[at] <= '9')
          return "it refers back to a group, which costs exponential time";
        break;
      default:
        break;
    }
    if (states > 0) last = states;
    groups.back() += states;
    if (groups.back() > kMostStates)
      return fmt::format("with its bounds written out it has more than {} characters", kMostStates);
  }
  return "";
}

std::shared_ptr<const regex_t> compiled(const std::string& text) {
  if (const auto problem = size_problem(text); !problem.empty())
    throw InputError(fmt::format("'{}' is no regular expression that is used here: {}",
                                 text.size() > 100 ? text.substr(0, 100) + " ..." : text, problem));
  auto made = std::make_unique<regex_t>();
  if (const int failed = ::regcomp(made.get(), text.c_str(), REG_EXTENDED | REG_NEWLINE); failed != 0) {
    std::array<char, 200> reason{};
    ::regerror(failed, made.get(), reason.data(), reason.size());
    throw InputError(fmt::format("'{}' is no regular expression: {}", text, reason.data()));
  }
  return std::shared_ptr<regex_t>(made.release(), [](regex_t* owned) {
    ::regfree(owned);
    delete owned;
  });
}

}  // namespace

Pattern::Pattern(const std::string& text) : compiled_(compiled(text)) {}

namespace {

// A search may take time that grows with the square of the line's length: two minutes for a megabyte of
// "error error error". Lines in which programs say something are short.
constexpr std::size_t kLongestLine = 1000;

}  // namespace

bool Pattern::matches(const std::string& line) const {
  return line.size() <= kLongestLine && ::regexec(compiled_.get(), line.c_str(), 0, nullptr, 0) == 0;
}

std::vector<std::string> Pattern::last_match(const std::string& text) const {
  for (std::size_t end = text.size();;) {
    const auto before = end == 0 ? std::string::npos : text.find_last_of("\n\r", end - 1);
    const auto begin = before == std::string::npos ? 0 : before + 1;
    if (end - begin <= kLongestLine)
      if (auto groups = last_match_in_line(text.substr(begin, end - begin)); !groups.empty()) return groups;
    if (before == std::string::npos) return {};
    end = before;
  }
}

std::vector<std::string> Pattern::last_match_in_line(const std::string& line) const {
  std::vector<regmatch_t> found(group_count() + 1);
  std::vector<std::string> groups;
  const char* at = line.c_str();
  int flags = 0;
  while (::regexec(compiled_.get(), at, found.size(), found.data(), flags) == 0) {
    groups.clear();
    for (std::size_t i = 1; i < found.size(); ++i)
      groups.push_back(found[i].rm_so < 0 ? "" : std::string(at + found[i].rm_so, at + found[i].rm_eo));
    // An empty match would be found again where it ends.
    const auto next = found[0].rm_eo > 0 ? found[0].rm_eo : 1;
    if (at + next > line.c_str() + line.size()) break;
    flags = REG_NOTBOL;
    at += next;
  }
  return groups;
}

}  // namespace orbs
