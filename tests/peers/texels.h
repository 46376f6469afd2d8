#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>

/// Where a renderer must find a texel and how it must filter, by the definition: sRGB decoded per texel, then
/// bilinear between texel centres at +0.5, v = 0 at the bottom row, each axis repeated or clamped.
namespace orbs::peers {

inline constexpr int kTexturePixels = 48;  // width and height of the images

/// How a texture of 5 x 3 texels, no two of them alike, is put onto a quad that fills the image;
/// coordinates run from -0.75 to 1.75 along both sides.
struct Look {
  std::string name;
  scene::Wrap wrap_u = scene::Wrap::Repeat;
  scene::Wrap wrap_v = scene::Wrap::Repeat;
  Mat4 matrix{};
  bool as_float = false;
  scene::RgbColour tint{1, 1, 1};
  Mat4 place{};  // of the instance, which must not move the image on the surface
};

/// The emitting quad before its camera; the texture file goes into `folder`.
scene::Scene texture_scene(const Look& look, const std::filesystem::path& folder);

/// What the texture gives at a point of the image: pixels from the top left corner.
double texture_value(const Look& look, double x_px, double y_px);

}  // namespace orbs::peers
