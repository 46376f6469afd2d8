#include "run/other_references.h"

#include "base/error.h"
#include "base/files.h"
#include "run/plan/scenes.h"
#include "scene/load/load_scene.h"

#include <algorithm>
#include <utility>

namespace orbs::run {

namespace {

// As it is in its file. One that was edited during the run may no longer be read: then what the run knows.
registry::Case whole_case(const registry::Case& planned) {
  try {
    return registry::load_case(planned.file);
  } catch (const InputError&) {
    return planned;
  }
}

// Today's hash of a scene that is not in the plan. A scene that cannot be read has none, and no reference is
// current for it.
std::string hash_of(const registry::CaseScene& wanted, const registry::Suite& suite) {
  try {
    const auto scene = scene::load_scene(wanted.file, suite.data, wanted.camera);
    return hash_text(scene_content_hash(scene, wanted.file));
  } catch (const InputError&) {
    return "unreadable";
  }
}

bool is_copied(const std::vector<std::filesystem::path>& files, const judge::ReferenceCopies& copies) {
  return !copies.folder.empty() && std::all_of(files.begin(), files.end(), [&](const auto& file) {
    return copies.copied.contains(file.filename().string());
  });
}

}  // namespace

std::map<std::string, image::Image> other_references(const Plan& plan,
                                                     const registry::Case& one_case,
                                                     const std::string& target,
                                                     const judge::ReferenceCopies& copies) {
  const auto whole = whole_case(one_case);
  auto hashes = plan.reference_hashes;
  // A scene that is judged by the reference of another case's is not checked: reading that one is not worth
  // it.
  for (const auto& scene : whole.scenes)
    if (!hashes.contains(scene.name) && registry::reference_name(scene) == scene.name)
      hashes[scene.name] = hash_of(scene, plan.suite);
  std::map<std::string, image::Image> others;
  for (const auto& name : registry::target_names(whole)) {
    if (name == target) continue;
    const auto files = judge::reference_files(whole, name, plan.suite.references);
    auto other = is_copied(files, copies)
                     ? judge::load_reference(whole, name, plan.suite.references, hashes, copies)
                     : judge::load_reference(whole, name, plan.suite.references, hashes, {},
                                             registry::reduced_size(plan.settings));
    if (other.image) others[name] = std::move(*other.image);
  }
  return others;
}

}  // namespace orbs::run
