#pragma once

#include "scene/geometry/mesh_file.h"
#include "scene/load/entry.h"

namespace orbs::scene {

/// The mesh entry `in` that has a "subdivision", tessellated; its origin is taken from its cage too. Its
/// materials are left to the caller. InputError at the key that is wrong.
MeshFile load_subdivision(json::ObjectReader& in, SceneBudget& left);

}  // namespace orbs::scene
