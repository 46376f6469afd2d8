#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace orbs::adapters::hydra {

/// The remap lists of all instances: the node that holds them, "" where there are none, and for each instance
/// the position of its list or -1. `last_material` is the greatest position in materials_lib.
struct RemapLists {
  std::string text;
  std::vector<int> of_instances;
};

RemapLists remap_lists(const scene::Scene& scene, int last_material);

}  // namespace orbs::adapters::hydra
