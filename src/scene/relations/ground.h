#pragma once

#include "scene/scene.h"

#include <string>
#include <variant>

/// Changes of one length of the scene alone, so that the ratio of lengths grows and nothing else.
namespace orbs::scene {

/// The scene in direct light (trace depth 1), with its ground enlarged until half its size is `ratio` times
/// the radius of all other objects. The ground is an instance that is level, below all else, opaque and
/// without texture. Its edge lies about 1 / ratio radians below the horizon, where lamps no longer light it.
/// The reason if the scene has no ground, or an environment that shines, of which a larger one would hide
/// more.
std::variant<Scene, std::string> with_large_ground(const Scene& scene, double ratio);

/// With a black sheet at `gap_m` below the ground, half as large, which the ground hides.
std::variant<Scene, std::string> with_sheet_below_ground(const Scene& scene, double gap_m);

/// With the camera moved backwards to `factor` times its distance from the point that it looks at, and its
/// field of view narrowed so that this point's surroundings keep their size. The reason if pixels become
/// finer than directions in float can tell.
std::variant<Scene, std::string> with_far_camera(const Scene& scene, double factor);

}  // namespace orbs::scene
