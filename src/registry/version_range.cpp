#include "registry/version_range.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

// "3.4.1 (hash 0)" of "Blender 3.4.1 (hash 0)"; empty if there is no digit.
std::string_view from_first_number(std::string_view text) {
  const auto first = text.find_first_of("0123456789");
  return first == std::string_view::npos ? std::string_view{} : text.substr(first);
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
  auto rest = from_first_number(version);
  if (rest.empty()) return false;
  const auto parts = take_version(rest);
  return std::all_of(range.bounds.begin(), range.bounds.end(),
                     [&](const auto& bound) { return meets(bound, parts); });
}

VersionRange range_of_version(const std::string& version) {
  const auto from = from_first_number(version);
  auto rest = from;
  const auto parts = take_version(rest);
  const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  const bool begins_within =
      from.size() < version.size() && is_letter(version[version.size() - from.size() - 1]);
  // "v1.2" is usual; "g3" and "OIDN2" are names.
  const bool is_of_name = parts.size() < 2 && (begins_within || (!rest.empty() && is_letter(rest.front())));
  if (parts.empty() || is_of_name) return {};
  return parse_version_range(fmt::format("={}", fmt::join(parts, ".")));
}

}  // namespace orbs::registry
