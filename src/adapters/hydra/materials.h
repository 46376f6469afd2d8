#pragma once

#include "adapters/format_limits.h"
#include "adapters/hydra/textures.h"
#include "scene/scene.h"

#include <string>

namespace orbs::adapters::hydra {

/// The levels beyond ORB.S: none is written.
const BeyondOrbs& beyond_orbs();

/// Why the material cannot be written, "" when it can or when beyond_orbs says why not.
std::string material_limit(const scene::Material& material);

/// All materials of the scene, each at the position of its index, by which meshes and remap lists call it; a
/// black one stands for each that no surface shows. InputError for a visible one that material_limit or
/// beyond_orbs refuse.
std::string material_nodes(const scene::Scene& scene, const TextureLibrary& textures);

/// What the mesh of a light is made of: `position` is that of the material, `light` that in lights_lib.
std::string light_material_node(const scene::Light& light, int position, int light_id);

}  // namespace orbs::adapters::hydra
