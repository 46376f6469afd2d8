#pragma once

#include "scene/load/entry.h"
#include "scene/scene.h"

namespace orbs::scene {

/// The mesh of the entry's "generator", without name and materials. InputError at the key that is wrong.
Mesh load_generated(json::ObjectReader& in, SceneBudget& left);

}  // namespace orbs::scene
