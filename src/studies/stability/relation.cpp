#include "studies/stability/relation.h"

#include "base/error.h"
#include "base/text.h"
#include "studies/stability/record.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

scene::Related unchanged(const scene::Scene& scene, double) {
  return scene::RelatedScenes{scene, scene, scene::SameImage{}};
}

std::vector<StabilityRelation> all_relations() {
  std::vector<StabilityRelation> all;
  for (const auto& relation : scene::relations()) all.push_back({relation, RenderChange::None});
  all.push_back(
      {{"threads", "three threads instead of one", "", {1}, true, unchanged}, RenderChange::Threads});
  all.push_back({{"seed", "other seeds", "", {1}, false, unchanged}, RenderChange::Seed});
  all.push_back({{"two_halves", "the mean of two renders with half the samples", "", {1}, false, unchanged},
                 RenderChange::TwoHalves});
  all.push_back({{kPrecisionRelation, "rays meet triangles in double precision", "", {1}, false, unchanged},
                 RenderChange::Precision});
  return all;
}

}  // namespace

std::vector<StabilityRelation> stability_relations(const std::vector<std::string>& patterns) {
  auto all = all_relations();
  if (patterns.empty()) return all;
  std::set<std::string> names;
  for (const auto& relation : all) names.emplace(relation.of_scenes.name);
  for (const auto& pattern : patterns)
    if (std::none_of(names.begin(), names.end(), [&](const auto& name) { return glob_match(pattern, name); }))
      throw InputError(fmt::format("there is no relation '{}'{}; orbs stability --help lists them", pattern,
                                   closest(pattern, names)));
  std::erase_if(all, [&](const auto& relation) {
    return std::none_of(patterns.begin(), patterns.end(),
                        [&](const auto& pattern) { return glob_match(pattern, relation.of_scenes.name); });
  });
  return all;
}

}  // namespace orbs::studies
