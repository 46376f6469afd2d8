#pragma once

#include "scene/scene.h"

#include <set>

/// Where a renderer puts v to the wrong side in the frames of normal maps, when it forgets what mirrors them.
namespace orbs::scene {

/// What it knows of the side to which v grows, of normal x (direction of u): nothing, or how the coordinates
/// lie on the mesh, but not that the matrix of an instance mirrors it.
enum class FrameSign { None, OfMesh };

/// The materials with normal maps that are shown in frames whose v it puts to the wrong side.
std::set<int> materials_in_wrong_frames(const Scene& scene, FrameSign known);

/// The same surfaces, where no material is shown in right and in wrong frames: that of the wrong ones is a
/// copy with a number of its own.
Scene with_materials_by_frames(Scene scene, FrameSign known);

}  // namespace orbs::scene
