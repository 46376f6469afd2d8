#pragma once

#include "base/matrix.h"

#include <cmath>
#include <filesystem>
#include <string>

namespace orbs::scene {

enum class Wrap { Repeat, Clamp };

/// LDR files (PNG, JPEG, BMP) hold sRGB values and are decoded to linear per texel, before bilinear
/// filtering; float files are linear. The bottom row of the image has v = 0; texel centres lie at +0.5.
struct Texture {
  std::string name;
  std::filesystem::path file;  // absolute
  Wrap wrap_u = Wrap::Repeat;
  Wrap wrap_v = Wrap::Repeat;
  bool operator==(const Texture&) const = default;
};

/// A texture as a material uses it: u' = m00 u + m01 v + m03, v' = m10 u + m11 v + m13 (ORB.S REQ_M5).
struct TextureUse {
  int texture = 0;  // index into Scene::textures
  Mat4 matrix;
  bool operator==(const TextureUse&) const = default;
};

/// The matrix without the whole repetitions by which it moves a texture that repeats: they change nothing but
/// the digits that floats have left for the rest.
inline Mat4 without_repetitions(Mat4 matrix, const Texture& texture) {
  if (texture.wrap_u == Wrap::Repeat) matrix(0, 3) -= std::floor(matrix(0, 3));
  if (texture.wrap_v == Wrap::Repeat) matrix(1, 3) -= std::floor(matrix(1, 3));
  return matrix;
}

}  // namespace orbs::scene
