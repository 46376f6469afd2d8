#pragma once

#include "scene/scene.h"

#include <string>
#include <variant>

/// Changes of surfaces that no light notices.
namespace orbs::scene {

/// In a box around all that is drawn and the camera, whose walls have opacity 0: all rays pass them, and none
/// of them counts as scattered. The reason if nothing is drawn.
std::variant<Scene, std::string> with_clear_box(const Scene& scene);

/// Each material that is shown and can be a part of a blend as the blend of itself with itself. The reason if
/// there is none.
std::variant<Scene, std::string> with_blends_of_themselves(const Scene& scene);

/// The textures of all materials looked up at second coordinates, which are the first ones. The reason if no
/// mesh shows a texture, or a mesh has second coordinates of its own.
std::variant<Scene, std::string> with_second_coordinates(const Scene& scene);

/// A pinhole camera with a lens whose radius is this share of the distance in focus: at most so many radians
/// of blur. The reason if the camera is none.
std::variant<Scene, std::string> with_small_lens(const Scene& scene, double share);

}  // namespace orbs::scene
