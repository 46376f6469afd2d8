#pragma once

#include "scene/load/entry.h"
#include "scene/scene.h"

namespace orbs::scene {

/// Reads an entry of "shapes" into scene.spheres, where it is a sphere without a matrix, or scene.shapes.
/// InputError at the key that is wrong.
void load_shape(json::ObjectReader& in, const Names& materials, Scene& scene);

}  // namespace orbs::scene
