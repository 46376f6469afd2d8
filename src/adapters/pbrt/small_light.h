#pragma once

#include "adapters/material_meshes.h"

#include <string>
#include <vector>

namespace orbs::adapters::pbrt {

/// Why pbrt's path integrator finds too little of the light that a light sends through smooth glass; "" when
/// it finds enough. It has no way to such a light but by chance: the light is hit as often as its solid angle
/// says.
std::string small_light_limit(const scene::Scene& scene, const std::vector<MaterialMesh>& meshes);

}  // namespace orbs::adapters::pbrt
