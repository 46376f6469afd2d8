#pragma once

#include "scene/relations/relation.h"

#include <string>
#include <string_view>
#include <vector>

namespace orbs::studies {

/// What is rendered differently where the scene stays as it is.
enum class RenderChange {
  None,
  Threads,    // three threads instead of those of the study
  Seed,       // other seeds
  TwoHalves,  // the mean of two renders with half the samples, of other seeds
  Precision   // with the arguments that the entry names for double precision
};

/// A relation of scenes, or of two ways to render one scene.
struct StabilityRelation {
  scene::Relation of_scenes;
  RenderChange render = RenderChange::None;
};

/// All relations of a study whose names match one of the patterns ("translate_*"); without patterns all.
/// InputError when a pattern matches none.
std::vector<StabilityRelation> stability_relations(const std::vector<std::string>& patterns);

}  // namespace orbs::studies
