#pragma once

#include "scene/scene.h"

#include <vector>

/// What a camera sees, without any light: the harness' own answer, by double-precision algebra over all
/// triangles, that shares no code with any renderer. Slow beside one, and meant for small images.
namespace orbs::studies {

/// Nothing, or the black back of a light.
inline constexpr int kNoThing = -1;

/// What lies behind one point of the image.
struct VisibleSurface {
  int thing = kNoThing;  // a material of the scene, or behind these, a light: materials.size() + its index
  float u = 0;           // texture coordinates of a mesh
  float v = 0;
};

/// A grid of points over each pixel, its outermost ones `margin_px` beyond the pixel's edge.
struct VisibilityGrid {
  int per_side = 8;
  double margin_px = 0.02;
};

struct Pixel {
  int x = 0;
  int y = 0;  // from the top
};

/// per_side^2 surfaces for each of the pixels, in their order. What a surface is made of does not matter:
/// every one is opaque.
std::vector<VisibleSurface> visible_surfaces_of_pixels(const scene::Scene& scene,
                                                       const std::vector<Pixel>& pixels,
                                                       const VisibilityGrid& grid,
                                                       int threads);

/// The same for all pixels of the camera, by rows from the top.
std::vector<VisibleSurface> primary_visibility(const scene::Scene& scene,
                                               const VisibilityGrid& grid,
                                               int threads);

}  // namespace orbs::studies
