#include "registry/version_range.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

constexpr std::size_t kMostDigits = 8;  // of a part: what int holds with certainty

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// "3.4.1" at the begin of the text; empty if it does not begin with a digit. Takes what it reads off the
// text.
std::vector<int> take_version(std::string_view& text) {
  std::vector<int> parts;
  while (!text.empty() && is_digit(text.front())) {
    std::size_t length = 0;
    while (length < text.size() && is_digit(text[length])) ++length;
    parts.push_back(length > kMostDigits ? 0 : static_cast<int>(*to_integer(text.substr(0, length))));
    text.remove_prefix(length);
    if (text.size() < 2 || text[0] != '.' || !is_digit(text[1])) break;
    text.remove_prefix(1);
  }
  return parts;
}

int compared(std::vector<int> a, std::vector<int> b) {
  const auto count = std::max(a.size(), b.size());
  a.resize(count, 0);
  b.resize(count, 0);
  if (a == b) return 0;
  return a < b ? -1 : 1;
}

bool meets(const VersionRange::Bound& bound, const std::vector<int>& version) {
  const int order = compared(version, bound.version);
  if (bound.comparison == "<") return order < 0;
  if (bound.comparison == "<=") return order <= 0;
  if (bound.comparison == ">") return order > 0;
  if (bound.comparison == ">=") return order >= 0;
  return order == 0;
}

VersionRange::Bound bound_of(std::string_view word) {
  constexpr std::array<std::string_view, 5> kComparisons{"<=", ">=", "<", ">", "="};
  VersionRange::Bound bound;
  for (const auto comparison : kComparisons)
    if (bound.comparison.empty() && word.starts_with(comparison)) {
      bound.comparison = comparison;
      word.remove_prefix(comparison.size());
    }
  if (!bound.comparison.empty()) bound.version = take_version(word);
  if (bound.version.empty() || !word.empty()) return {};
  return bound;
}

}  // namespace

VersionRange parse_version_range(const std::string& text) {
  VersionRange range{text, {}};
  for (const auto& word : words_of(text)) {
    range.bounds.push_back(bound_of(word));
    if (range.bounds.back().version.empty())
      throw InputError(fmt::format(
          "'{}' is no comparison of a version; write such as '<4.0' or '>=3.4 <4' (<, <=, =, >=, >)", word));
  }
  if (range.bounds.empty()) throw InputError("must hold a comparison such as '<4.0'");
  return range;
}

bool is_in_range(const VersionRange& range, const std::string& version) {
  if (range.bounds.empty()) return true;
  const auto first = version.find_first_of("0123456789");
  if (first == std::string::npos) return false;
  auto rest = std::string_view(version).substr(first);
  const auto parts = take_version(rest);
  return std::all_of(range.bounds.begin(), range.bounds.end(),
                     [&](const auto& bound) { return meets(bound, parts); });
}

}  // namespace orbs::registry
