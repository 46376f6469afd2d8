#include "registry/choose_cases.h"

#include "base/error.h"
#include "registry/filters.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

template <typename Items, typename NameOf>
std::vector<std::string> names_of(const Items& items, NameOf&& name_of) {
  std::vector<std::string> names;
  for (const auto& item : items)
    if (const auto name = name_of(item); std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  return names;
}

}  // namespace

Case with_targets(const Case& whole, const std::set<std::string>& chosen) {
  Case part = whole;
  auto needed = chosen;
  std::erase_if(part.differences, [&](const auto& difference) { return !chosen.contains(difference.name); });
  for (const auto& difference : part.differences) needed.insert({difference.of, difference.minus});
  std::erase_if(part.scenes, [&](const auto& scene) { return !needed.contains(scene.name); });
  const auto gone = [&](const std::string& name) { return !needed.contains(name); };
  std::erase_if(part.masks, [&](const auto& mask) { return gone(mask.target); });
  std::erase_if(part.pixel_checks, [&](const auto& check) { return gone(check.target); });
  std::erase_if(part.path_shares, [&](const auto& share) { return gone(share.scene); });
  return part;
}

std::vector<Case> choose_cases(const std::vector<Case>& all, const RunSettings& settings) {
  const auto cases =
      select_names(names_of(all, [](const auto& c) { return c.name; }), settings.cases, "case");
  const auto requirements = select_names(names_of(all, [](const auto& c) { return c.requirement; }),
                                         settings.requirements, "requirement");
  std::vector<std::string> all_targets;
  for (const auto& one_case : all)
    for (const auto& name : target_names(one_case)) all_targets.push_back(name);
  const auto targets = select_names(all_targets, settings.scenes, "scene");
  const auto holds = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  std::vector<Case> chosen;
  for (const auto& one_case : all) {
    if (!holds(cases, one_case.name) || !holds(requirements, one_case.requirement)) continue;
    auto part = with_targets(one_case, {targets.begin(), targets.end()});
    if (!part.scenes.empty()) chosen.push_back(std::move(part));
  }
  if (chosen.empty())
    throw InputError(
        fmt::format("no scene is left: nothing matches case '{}', requirement '{}' and scene '{}' at once",
                    settings.cases, settings.requirements, settings.scenes));
  return chosen;
}

}  // namespace orbs::registry
