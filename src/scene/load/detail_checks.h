#pragma once

#include "scene/scene.h"

#include <string>

namespace orbs::scene {

/// What is wrong with the detail of a material in a scene that is read: its textures hold colours, or what
/// shows it cannot have it. "" if nothing is. `key` gets the key to blame.
std::string detail_problem(const Scene& scene, int material, std::string& key);

/// What is wrong with the texture coordinates that the textures of a material ask for: a surface that shows
/// it lacks the second ones. "" if nothing is.
std::string uv_set_problem(const Scene& scene, int material);

}  // namespace orbs::scene
