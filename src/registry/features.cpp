#include "registry/features.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

constexpr std::string_view kOrder = "GMLA";

struct Group {
  char letter;
  int highest;
  std::string_view what;
};
constexpr std::array kGroups{Group{'G', 5, "geometry"},
                             Group{'M', 8, "materials"},
                             Group{'L', 4, "lights"},
                             Group{'A', 4, "algorithms"},
                             Group{'B', 9, "appearance"},
                             Group{'C', 5, "cameras"},
                             Group{'D', 6, "distant and point lights"},
                             Group{'E', 6, "effects of light"},
                             Group{'N', 6, "textures and surface detail"},
                             Group{'V', 1, "layers"},
                             Group{'S', 7, "shapes"},
                             Group{'T', 3, "motion"},
                             Group{'I', 2, "integrators"}};

int rank(char group) {
  const auto at = kOrder.find(group);
  return at == std::string_view::npos ? 100 + group : static_cast<int>(at);
}

[[noreturn]] void bad(std::string_view part, const std::string& problem) {
  throw InputError(fmt::format("feature number '{}': {}; expected for example G1, L7-(2,3) or L7+(11-13,15)",
                               part, problem));
}

int parse_level(std::string_view part, std::string_view digits, int min) {
  const auto value = to_integer(trim(digits));
  const bool only_digits =
      !trim(digits).empty() && std::isdigit(static_cast<unsigned char>(trim(digits).front())) != 0;
  if (!value || !only_digits) bad(part, fmt::format("'{}' is no number", digits));
  if (*value < min || *value > kHighestLevel)
    bad(part, fmt::format("{} does not lie in [{}, {}]", *value, min, kHighestLevel));
  return static_cast<int>(*value);
}

// "2,3" or "11-13, 15-18"
std::set<int> parse_list(std::string_view part, std::string_view list) {
  std::set<int> levels;
  for (const auto& item : split(list, ',')) {
    const auto dash = item.find('-');
    const int first = parse_level(part, std::string_view(item).substr(0, dash), 1);
    const int last =
        dash == std::string::npos ? first : parse_level(part, std::string_view(item).substr(dash + 1), 1);
    if (last < first) bad(part, fmt::format("the range '{}' runs backwards", trim(item)));
    for (int level = first; level <= last; ++level)
      if (!levels.insert(level).second) bad(part, fmt::format("{} is listed twice", level));
  }
  return levels;
}

void leave_out(std::string_view part, int base, const std::set<int>& list, std::set<int>& levels) {
  for (const int level : list) {
    if (level > base) bad(part, fmt::format("{} is left out but not among 1 to {}", level, base));
    levels.erase(level);
  }
}

void add(std::string_view part, int base, const std::set<int>& list, std::set<int>& levels) {
  for (const int level : list) {
    if (level <= base) bad(part, fmt::format("{} is added but already among 1 to {}", level, base));
    levels.insert(level);
  }
}

std::set<int> parse_levels(std::string_view part) {
  const auto sign = std::min(part.find_first_of("+-"), part.size());
  const int base = parse_level(part, part.substr(1, sign - 1), 0);
  std::set<int> levels;
  for (int level = 1; level <= base; ++level) levels.insert(level);
  for (auto rest = part.substr(sign); !rest.empty();) {
    const bool plus = rest.front() == '+';
    const auto close = rest.find(')');
    const auto inner = trim(rest.substr(1, close == std::string_view::npos ? close : close - 1));
    if ((!plus && rest.front() != '-') || close == std::string_view::npos || !inner.starts_with('('))
      bad(part, "a list in brackets must follow + or -");
    const auto list = parse_list(part, inner.substr(1));
    plus ? add(part, base, list, levels) : leave_out(part, base, list, levels);
    rest = trim(rest.substr(close + 1));
  }
  return levels;
}

// Two neighbours as "2,3", three and more as "11-13".
std::string list_text(const std::set<int>& levels) {
  std::string text;
  for (auto it = levels.begin(); it != levels.end();) {
    const int first = *it;
    int last = first;
    while (++it != levels.end() && *it == last + 1) last = *it;
    if (!text.empty()) text += ",";
    text += std::to_string(first);
    if (last > first) text += fmt::format("{}{}", last == first + 1 ? ',' : '-', last);
  }
  return text;
}

std::string group_text(char group, int base, const std::set<int>& levels, const std::set<int>& undecided) {
  std::set<int> missing;
  std::set<int> beyond;
  for (int level = 1; level <= base; ++level)
    if (!levels.contains(level) && !undecided.contains(level)) missing.insert(level);
  for (const int level : levels)
    if (level > base) beyond.insert(level);
  auto text = fmt::format("{}{}", group, base);
  if (!missing.empty()) text += fmt::format("-({})", list_text(missing));
  if (!beyond.empty()) text += fmt::format("+({})", list_text(beyond));
  if (!undecided.empty()) text += fmt::format("?({})", list_text(undecided));
  return text;
}

std::string shortest_group_text(char group, const std::set<int>& levels, const std::set<int>& undecided) {
  const int highest = levels.empty() ? 0 : *levels.rbegin();
  std::string best = group_text(group, highest, levels, undecided);
  for (int base = highest - 1; base >= 0; --base) {
    auto text = group_text(group, base, levels, undecided);
    if (text.size() < best.size()) best = std::move(text);
  }
  return best;
}

}  // namespace

FeatureSet parse_features(std::string_view text) {
  FeatureSet features;
  for (const auto& item : split(text, '/')) {
    const auto part = trim(item);
    if (part.empty() || std::isupper(static_cast<unsigned char>(part.front())) == 0)
      bad(part, "each part between '/' starts with the capital letter of a group");
    if (!features.emplace(part.front(), parse_levels(part)).second)
      bad(part, fmt::format("group {} stands there twice", part.front()));
  }
  return features;
}

std::string format_features(const FeatureSet& features, const FeatureSet& undecided) {
  static const std::set<int> kNone;
  std::vector<char> groups;
  for (const auto& [group, levels] : features) groups.push_back(group);
  for (const auto& [group, levels] : undecided)
    if (!features.contains(group)) groups.push_back(group);
  std::sort(groups.begin(), groups.end(), [](char a, char b) { return rank(a) < rank(b); });
  std::string text;
  for (const char group : groups) {
    if (!text.empty()) text += '/';
    const auto open = undecided.find(group);
    const auto known = features.find(group);
    text += known == features.end()
                ? fmt::format("{}?", group)
                : shortest_group_text(group, known->second, open == undecided.end() ? kNone : open->second);
  }
  return text;
}

RequirementCode parse_requirement(std::string_view text) {
  if (text.size() < 2 || std::isupper(static_cast<unsigned char>(text.front())) == 0)
    throw InputError(
        fmt::format("'{}' is no requirement; expected a group letter and a number, for example M7", text));
  return {text.front(), parse_level(text, text.substr(1), 1)};
}

std::string format_requirement(RequirementCode code) { return fmt::format("{}{}", code.group, code.level); }

std::string_view what_of_group(char letter) {
  const auto group =
      std::find_if(kGroups.begin(), kGroups.end(), [&](const auto& one) { return one.letter == letter; });
  return group == kGroups.end() ? std::string_view() : group->what;
}

void refuse_unknown(RequirementCode code) {
  std::string known;
  for (const auto& [letter, highest, what] : kGroups) {
    if (code.group == letter && code.level <= highest) return;
    known += fmt::format("{}{}1", known.empty() ? "" : ", ", letter);
    if (highest > 1) known += fmt::format(" to {}{}", letter, highest);
  }
  throw InputError(fmt::format("there is no requirement {}; there are {}", format_requirement(code), known));
}

void refuse_unknown(const FeatureSet& features) {
  for (const auto& [group, levels] : features)
    refuse_unknown(RequirementCode{group, levels.empty() ? 0 : *levels.rbegin()});
}

std::string to_text(const FeatureSet& features) { return format_features(features); }

void from_text(std::string_view text, FeatureSet& features) {
  features = parse_features(text);
  refuse_unknown(features);
}

bool comes_before(RequirementCode a, RequirementCode b) {
  return std::pair(rank(a.group), a.level) < std::pair(rank(b.group), b.level);
}

bool has_feature(const FeatureSet& features, RequirementCode code) {
  const auto group = features.find(code.group);
  return group != features.end() && group->second.contains(code.level);
}

std::set<std::string> feature_codes(const FeatureSet& features) {
  std::set<std::string> codes;
  for (const auto& [group, levels] : features)
    for (const int level : levels) codes.insert(format_requirement({group, level}));
  return codes;
}

}  // namespace orbs::registry
