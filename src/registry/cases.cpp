#include "registry/cases.h"

#include "base/error.h"
#include "registry/features.h"
#include "registry/filters.h"
#include "registry/suite_checks.h"

#include <algorithm>
#include <filesystem>
#include <map>
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

}  // namespace orbs::registry
