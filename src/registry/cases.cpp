#include "registry/cases.h"

#include "base/error.h"
#include "base/text.h"
#include "registry/features.h"
#include "registry/filters.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

// Hidden folders are those of other programs.
std::vector<std::filesystem::path> case_folders(const Suite& suite) {
  std::error_code failed;
  std::vector<std::filesystem::path> folders;
  for (const auto& entry : std::filesystem::directory_iterator(suite.cases, failed)) {
    std::error_code leads_nowhere;
    if (!entry.path().filename().string().starts_with('.') && entry.is_directory(leads_nowhere))
      folders.push_back(entry.path());
  }
  if (failed)
    throw InputError(fmt::format("{}: the cases of suite '{}' cannot be read: {}", suite.cases.string(),
                                 suite.name, failed.message()));
  std::sort(folders.begin(), folders.end());
  for (const auto& folder : folders)
    if (std::error_code ignored; !std::filesystem::exists(folder / "case.json", ignored))
      throw InputError(
          fmt::format("{}: is a folder of suite '{}' without case.json; write one, or move the folder "
                      "elsewhere",
                      folder.string(), suite.name));
  return folders;
}

}  // namespace

std::vector<Case> load_cases(const Suite& suite) {
  std::vector<Case> cases;
  for (const auto& folder : case_folders(suite)) cases.push_back(load_case(folder / "case.json"));
  for (const auto& one_case : cases)
    for (const auto& scene : one_case.scenes) refuse_outside(scene.file, suite.cases, one_case);
  if (cases.empty())
    throw InputError(fmt::format("{}: suite '{}' has no case there", suite.cases.string(), suite.name));
  std::stable_sort(cases.begin(), cases.end(), [](const Case& a, const Case& b) {
    return comes_before(parse_requirement(a.requirement), parse_requirement(b.requirement));
  });
  refuse_conflicts(cases);
  check_references(cases);
  return cases;
}

std::vector<CaseScene> scenes_of(const Suite& suite, const std::string& patterns) {
  std::vector<std::string> names;
  std::map<std::string, CaseScene> by_name;
  for (const auto& one_case : load_cases(suite))
    for (const auto& scene : one_case.scenes)
      if (by_name.emplace(scene.name, scene).second) names.push_back(scene.name);
  std::vector<CaseScene> chosen;
  for (const auto& name : select_names(names, patterns, "scene")) chosen.push_back(by_name.at(name));
  return chosen;
}

void refuse_conflicts(const std::vector<Case>& cases) {
  std::map<std::string, std::pair<const Case*, const CaseScene*>> scenes;
  std::map<std::string, const Case*> differences;
  for (const auto& one_case : cases) {
    for (const auto& scene : one_case.scenes) {
      const auto [first, is_new] = scenes.try_emplace(scene.name, &one_case, &scene);
      const auto& [other_case, other] = first->second;
      if (!is_new && other->reference != scene.reference)
        throw InputError(fmt::format(
            "{}: scene '{}' is judged by the reference of '{}', but by that of '{}' in {}; use another name",
            one_case.file.string(), scene.name, reference_name(scene), reference_name(*other),
            other_case->file.string()));
      if (!is_new && other->accepted != scene.accepted)
        throw InputError(
            fmt::format("{}: scene '{}' has other accepted references than in {}; use another name",
                        one_case.file.string(), scene.name, other_case->file.string()));
      if (!is_new && other->arguments != scene.arguments)
        throw InputError(fmt::format("{}: scene '{}' has other arguments than in {}; use another name",
                                     one_case.file.string(), scene.name, other_case->file.string()));
      if (!is_new && other->camera != scene.camera)
        throw InputError(fmt::format("{}: scene '{}' has another camera than in {}; use another name",
                                     one_case.file.string(), scene.name, other_case->file.string()));
      if (!is_new && (other->file != scene.file || other->spp != scene.spp))
        throw InputError(
            fmt::format("{}: scene '{}' is {} with {} spp, but {} with {} spp in {}; use another name",
                        one_case.file.string(), scene.name, scene.file.string(), scene.spp,
                        other->file.string(), other->spp, other_case->file.string()));
    }
    for (const auto& difference : one_case.differences)
      if (!differences.try_emplace(difference.name, &one_case).second)
        throw InputError(fmt::format("{}: difference '{}' is also one of {}; use another name",
                                     one_case.file.string(), difference.name,
                                     differences[difference.name]->file.string()));
  }
  for (const auto& [name, one_case] : differences)
    if (scenes.contains(name))
      throw InputError(fmt::format("{}: difference '{}' has the name of a scene in {}; use another name",
                                   one_case->file.string(), name, scenes[name].first->file.string()));
}

void refuse_outside(const std::filesystem::path& file,
                    const std::filesystem::path& folder,
                    const Case& one_case) {
  const auto inside = std::filesystem::weakly_canonical(folder);
  const auto meant = std::filesystem::weakly_canonical(file);
  if (const auto relative = meant.lexically_relative(inside); relative.empty() || *relative.begin() == "..")
    throw InputError(fmt::format("{}: the scene {} lies outside the suite's cases in {}; copy it there",
                                 one_case.file.string(), meant.string(), inside.string()));
}

void check_references(const std::vector<Case>& cases) {
  std::set<std::string> with_reference;
  for (const auto& one_case : cases)
    for (const auto& scene : one_case.scenes)
      if (scene.reference.empty() && scene.no_reference.empty()) with_reference.insert(scene.name);
  for (const auto& one_case : cases)
    for (const auto& scene : one_case.scenes)
      if (scene.no_reference.empty() && !with_reference.contains(reference_name(scene)))
        throw InputError(fmt::format(
            "{}: scene '{}' is to be judged by the reference of '{}', but the suite has no scene of that name "
            "with its own reference{}",
            one_case.file.string(), scene.name, scene.reference, closest(scene.reference, with_reference)));
  for (const auto& one_case : cases)
    for (const auto& scene : one_case.scenes)
      for (const auto& accepted : scene.accepted)
        if (!with_reference.contains(accepted.reference))
          throw InputError(fmt::format(
              "{}: scene '{}' accepts the reference of '{}', but no scene of the suite with a reference of its "
              "own has that name{}",
              one_case.file.string(), scene.name, accepted.reference,
              closest(accepted.reference, with_reference)));
}

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
