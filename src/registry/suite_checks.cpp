#include "registry/suite_checks.h"

#include "base/error.h"
#include "base/text.h"

#include <map>
#include <set>

#include <fmt/format.h>

namespace orbs::registry {

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

}  // namespace orbs::registry
