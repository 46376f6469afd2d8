#pragma once

#include "scene/load/entry.h"
#include "scene/scene.h"

namespace orbs::scene {

/// Appends one instance, or many when the entry has "scatter". InputError at the key that is wrong.
void load_instances(json::ObjectReader in,
                    const Names& meshes,
                    const Names& materials,
                    SceneBudget& left,
                    std::vector<Instance>& out);

}  // namespace orbs::scene
