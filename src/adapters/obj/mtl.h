#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

/// Materials as MTL has them (Wavefront's "MTL material format", 1995, as Bourke and Ramey publish it), and
/// Ke and map_Ke, which it lacks and most readers know. What MTL cannot say stands in a comment beside the
/// nearest that it can, and in the description (description.h) in full.
namespace orbs::adapters::obj {

/// The file of a texture beside the scene: "scene-texture0.png".
std::string texture_file(const scene::Scene& scene, int texture, const std::string& stem);

/// The materials that the scene shows, under these names by their index. InputError for a type that
/// material_limit refuses.
std::string mtl_text(const scene::Scene& scene,
                     const std::vector<std::string>& names,
                     const std::string& stem);

/// Why the material stands neither in MTL nor in the description; "" when it does.
std::string material_limit(const scene::Material& material);

}  // namespace orbs::adapters::obj
