#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

/// What the camera sees at points of its image, for sentences that name it.
namespace orbs::scene {

/// In pixels from the upper left corner of the image.
struct ImagePoint {
  double x = 0;
  double y = 0;
};

/// Of each region the name of the surface that at least half of its points show, at the start of the frame:
/// that of the instance, else of its mesh, with the material where the mesh shows several; or that of a
/// light. All surfaces count as opaque. "" where no surface is seen by so many, and in scenes with shapes
/// that are no triangles or with too many triangles to test each of them.
std::vector<std::string> seen_by_most(const Scene& given,
                                      const std::vector<std::vector<ImagePoint>>& regions);

}  // namespace orbs::scene
