#pragma once

#include "scene/scene.h"

#include <string>
#include <variant>

/// Changes of surfaces that no light notices.
namespace orbs::scene {

/// In a box around all that is drawn and the camera, whose walls have opacity 0: all rays pass them, and none
/// of them counts as scattered. The reason if nothing is drawn.
std::variant<Scene, std::string> with_clear_box(const Scene& scene);

}  // namespace orbs::scene
