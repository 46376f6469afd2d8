#pragma once

#include "json/object_reader.h"
#include "json/writer.h"
#include "scene/texture.h"

#include <optional>
#include <string>
#include <vector>

/// What a surface may have beside its material's model. The textures hold numbers, no colours.
namespace orbs::scene {

class Names;

/// Normals by a texture in tangent space: x = 2r - 1 along u, y = 2g - 1 along increasing v, z = 2b - 1 along
/// the shading normal; x and y times the strength.
struct NormalMap {
  TextureUse texture;
  double strength = 1;
  bool operator==(const NormalMap&) const = default;
};

/// Heights above the surface in metres of the world: those of a white texel, times the red of the texture.
struct BumpMap {
  TextureUse texture;
  double height_m = 1;
  bool operator==(const BumpMap&) const = default;
};

struct SurfaceDetail {
  double opacity = 1;  // share of the rays that meet the surface; the others pass straight on
  std::optional<TextureUse> opacity_texture;  // its largest channel multiplies it
  std::optional<NormalMap> normal_map;
  std::optional<BumpMap> bump_map;
  bool operator==(const SurfaceDetail&) const = default;
};

inline bool lets_rays_pass(const SurfaceDetail& detail) {
  return detail.opacity < 1 || detail.opacity_texture.has_value();
}

inline bool turns_normals(const SurfaceDetail& detail) { return detail.normal_map || detail.bump_map; }

/// A texture as a material names it: its name, or an object with "name", "matrix" and
/// "uv_set".
TextureUse load_texture_use(json::ObjectReader& in, const std::string& key, const Names& textures);
void write_texture_use(json::Writer& out,
                       const std::vector<Texture>& textures,
                       const std::string& key,
                       const TextureUse& use);

SurfaceDetail load_surface_detail(json::ObjectReader& in, const Names& textures);
void write(json::Writer& out, const std::vector<Texture>& textures, const SurfaceDetail& detail);

}  // namespace orbs::scene
