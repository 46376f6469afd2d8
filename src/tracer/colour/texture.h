#pragma once

#include "base/vec.h"
#include "scene/scene.h"

#include <array>
#include <vector>

namespace orbs::tracer {

/// A texture in memory: linear RGB texels, row 0 at the bottom (v = 0).
struct TexelGrid {
  int width = 0;
  int height = 0;
  std::vector<Vec3f> texels;
  scene::Wrap wrap_u = scene::Wrap::Repeat;
  scene::Wrap wrap_v = scene::Wrap::Repeat;
  Vec3f average;
  bool is_plain = true;  // neither mirrored nor looked up without interpolation
  bool is_nearest = false;
};

/// Loads a texture file; throws InputError. sRGB values of LDR files are decoded to linear per texel, float
/// files are linear; a single channel is grey. AsStored leaves sRGB values as they are, which is a fault.
enum class Texels { Linear, AsStored };
TexelGrid load_texels(const scene::Texture& texture, Texels texels = Texels::Linear);

/// Bilinear interpolation between texel centres at +0.5, or the texel at the place where the grid says so.
Vec3f lookup(const TexelGrid& grid, Vec2f uv);

/// How the red of what lookup gives changes with u and with v; of the bilinear interpolation, inside its
/// cell. Zero where nothing is interpolated.
Vec2f slope_of_red(const TexelGrid& grid, Vec2f uv);

/// Affine map of texture coordinates: u' = m[0] u + m[1] v + m[2], v' = m[3] u + m[4] v + m[5].
struct UvMap {
  std::array<float, 6> m{1, 0, 0, 0, 1, 0};
  int set = 0;  // of the mesh's coordinates: 1 are the second ones
};

UvMap uv_map(const scene::TextureUse& use, const scene::Texture& texture);

inline Vec2f apply(const UvMap& map, Vec2f uv) {
  return {map.m[0] * uv.x + map.m[1] * uv.y + map.m[2], map.m[3] * uv.x + map.m[4] * uv.y + map.m[5]};
}

}  // namespace orbs::tracer
