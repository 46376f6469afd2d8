#include "scene/load_parts.h"

namespace orbs::scene {

namespace {

// Above 1 a surface would reflect more than it receives, and the light between two such surfaces has no
// finite sum.
constexpr json::Range kShare{0.0, 1.0};

std::optional<TextureUse> load_texture_use(json::ObjectReader& in, const Names& textures) {
  if (!in.has("texture")) return std::nullopt;
  if (in.holds_text("texture")) return TextureUse{textures.find(in, "texture"), Mat4{}};
  auto use = in.object("texture");
  TextureUse result{textures.find(use, "name"), load_matrix(use, "matrix")};
  use.finish();
  return result;
}

double load_ior(json::ObjectReader& in) { return in.number("ior", {0.1, 10.0}); }

// Below 1e-4 the GGX lobe is narrower than float directions can resolve: such a surface is a mirror.
double load_alpha(json::ObjectReader& in) { return in.number("alpha", {1e-4, 1.0}); }

MaterialModel load_model(json::ObjectReader& in, const Names& textures) {
  const std::string type =
      in.one_of("type", {"lambert", "oren_nayar", "mirror", "glass", "ggx", "rough_glass", "emission"});
  if (type == "lambert") return Lambert{in.vec3("reflectance", kShare), load_texture_use(in, textures)};
  if (type == "oren_nayar")
    return OrenNayar{in.vec3("reflectance", kShare), in.number("roughness", kShare),
                     load_texture_use(in, textures)};
  if (type == "mirror") return Mirror{in.vec3("reflectance", kShare)};
  if (type == "glass") return Glass{in.vec3_or("colour", {1, 1, 1}, kShare), load_ior(in)};
  if (type == "ggx") return Ggx{in.vec3("colour", kShare), load_alpha(in)};
  if (type == "rough_glass")
    return RoughGlass{in.vec3_or("colour", {1, 1, 1}, kShare), load_ior(in), load_alpha(in)};
  return Emission{in.vec3("radiance", json::kNotNegative), load_texture_use(in, textures)};
}

}  // namespace

Material load_material(json::ObjectReader in, const Names& textures) {
  Material material;
  material.name = in.text("name");
  material.model = load_model(in, textures);
  in.finish();
  return material;
}

}  // namespace orbs::scene
