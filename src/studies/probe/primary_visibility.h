#pragma once

#include "scene/scene.h"

#include <vector>

/// Primary visibility of a scene through a perspective, of a lens through its middle, computed in double
/// precision by testing all triangles. It shares no code with any renderer, so that it can judge them. Slow;
/// meant for small images.
namespace orbs::studies {

/// The background, or the black back of a light.
inline constexpr int kNoObject = -1;

/// The nearest surface behind one point of the image.
struct VisibleSurface {
  int object = kNoObject;  // index of a material of the scene; of a light: materials.size() + its index
  float u = 0;             // texture coordinates of a mesh
  float v = 0;
  double depth_m = 0;  // along the axis; 0 of the background
  Vec3f normal;        // unit, of a mesh: interpolated, in the world, as the mesh has it
  Vec3f along_u;       // how the point moves in the world with u and with v; 0 where they say nothing
  Vec3f along_v;
};

/// A grid of points over each pixel; the outermost ones lie `margin_px` outside the pixel's edges.
struct VisibilityGrid {
  int per_side = 8;
  double margin_px = 0.02;
};

struct Pixel {
  int x = 0;
  int y = 0;  // from the top
};

/// per_side^2 surfaces for each of the pixels, in their order. All surfaces count as opaque, glass and
/// polarisers too.
std::vector<VisibleSurface> visible_surfaces_of_pixels(const scene::Scene& scene,
                                                       const std::vector<Pixel>& pixels,
                                                       const VisibilityGrid& grid,
                                                       int threads);

/// The same for all pixels of the camera, row by row from the top.
std::vector<VisibleSurface> primary_visibility(const scene::Scene& scene,
                                               const VisibilityGrid& grid,
                                               int threads);

}  // namespace orbs::studies
