#pragma once

#include "base/matrix.h"

#include <cmath>
#include <filesystem>
#include <string>

namespace orbs::scene {

/// What stands beyond the edge of an image, by the index i of a texel among n: repeat takes i mod n, clamp
/// the nearest of 0 to n - 1, mirror i mod 2n, and 2n - 1 - that where it is n or more, so that each edge
/// texel stands there twice.
enum class Wrap { Repeat, Clamp, Mirror };

/// Linear interpolates between the centres of four texels, Nearest takes the texel that the place lies in.
enum class Filter { Linear, Nearest };

/// What the values of LDR files (PNG, JPEG, BMP) are: colours as sRGB or plain numbers. Float files hold
/// linear values in either case.
enum class Encoding { Srgb, Linear };

/// sRGB values are decoded to linear per texel, before filtering. The bottom row of the image has v = 0;
/// texel centres lie at +0.5.
struct Texture {
  std::string name;
  std::filesystem::path file;  // absolute
  Wrap wrap_u = Wrap::Repeat;
  Wrap wrap_v = Wrap::Repeat;
  Filter filter = Filter::Linear;
  Encoding encoding = Encoding::Srgb;
  bool operator==(const Texture&) const = default;
};

/// A texture as a material uses it: u' = m00 u + m01 v + m03, v' = m10 u + m11 v + m13 (ORB.S REQ_M5).
struct TextureUse {
  int texture = 0;  // index into Scene::textures
  Mat4 matrix;
  int uv_set = 0;  // 1: the second texture coordinates of the mesh
  bool operator==(const TextureUse&) const = default;
};

/// The words of the scene file.
inline const char* word_of(Wrap wrap) {
  if (wrap == Wrap::Mirror) return "mirror";
  return wrap == Wrap::Clamp ? "clamp" : "repeat";
}
inline const char* word_of(Filter filter) { return filter == Filter::Nearest ? "nearest" : "linear"; }

/// The matrix without the whole periods by which it moves a texture that repeats: they change nothing but the
/// digits that floats have left for the rest. A mirrored image comes back after two of its lengths.
inline Mat4 without_repetitions(Mat4 matrix, const Texture& texture) {
  const auto rest = [](double shift, Wrap wrap) {
    if (wrap == Wrap::Clamp) return shift;
    return wrap == Wrap::Mirror ? shift - 2 * std::floor(shift / 2) : shift - std::floor(shift);
  };
  matrix(0, 3) = rest(matrix(0, 3), texture.wrap_u);
  matrix(1, 3) = rest(matrix(1, 3), texture.wrap_v);
  return matrix;
}

}  // namespace orbs::scene
