#include "scene/surface_detail.h"

#include "base/nth.h"
#include "scene/load/entry.h"

namespace orbs::scene {

TextureUse load_texture_use(json::ObjectReader& in, const std::string& key, const Names& textures) {
  if (in.holds_text(key)) return {textures.find(in, key), Mat4{}};
  auto use = in.object(key);
  TextureUse result{textures.find(use, "name"), load_matrix(use, "matrix"),
                    use.integer_or("uv_set", 0, 0, 1)};
  use.finish();
  return result;
}

void write_texture_use(json::Writer& out,
                       const std::vector<Texture>& textures,
                       const std::string& key,
                       const TextureUse& use) {
  out.key(key).begin_object();
  out.member("name", nth(textures, use.texture).name);
  out.key("matrix").numbers(use.matrix.m);
  if (use.uv_set != 0) out.member("uv_set", use.uv_set);
  out.end_object();
}

namespace {

NormalMap load_normal_map(json::ObjectReader in, const Names& textures) {
  NormalMap map{load_texture_use(in, "texture", textures), 1};
  const Mat4& m = map.texture.matrix;
  // Along which directions would a map that is turned say its normals?
  if (m(0, 1) != 0 || m(1, 0) != 0 || !(m(0, 0) > 0) || !(m(1, 1) > 0))
    in.fail("texture", "a normal map may be moved and stretched, not turned or mirrored");
  constexpr double kMostStrength = 100;
  if (in.has("strength")) map.strength = in.number("strength", {0, kMostStrength});
  in.finish();
  return map;
}

BumpMap load_bump_map(json::ObjectReader in, const Names& textures) {
  BumpMap map{load_texture_use(in, "texture", textures), in.number("height", {-1e6, 1e6})};
  in.finish();
  return map;
}

}  // namespace

SurfaceDetail load_surface_detail(json::ObjectReader& in, const Names& textures) {
  SurfaceDetail detail;
  detail.opacity = in.number_or("opacity", 1, {0, 1});
  if (in.has("opacity_texture")) detail.opacity_texture = load_texture_use(in, "opacity_texture", textures);
  if (in.has("normal_map")) detail.normal_map = load_normal_map(in.object("normal_map"), textures);
  if (in.has("bump_map")) detail.bump_map = load_bump_map(in.object("bump_map"), textures);
  if (detail.normal_map && detail.bump_map)
    in.fail("bump_map", "has no place beside 'normal_map': each says where the normals point");
  return detail;
}

void write(json::Writer& out, const std::vector<Texture>& textures, const SurfaceDetail& detail) {
  if (detail.opacity < 1) out.member("opacity", detail.opacity);
  if (detail.opacity_texture) write_texture_use(out, textures, "opacity_texture", *detail.opacity_texture);
  if (const auto& map = detail.normal_map) {
    out.key("normal_map").begin_object();
    write_texture_use(out, textures, "texture", map->texture);
    out.member("strength", map->strength).end_object();
  }
  if (const auto& map = detail.bump_map) {
    out.key("bump_map").begin_object();
    write_texture_use(out, textures, "texture", map->texture);
    out.member("height", map->height_m).end_object();
  }
}

}  // namespace orbs::scene
