#include "scene/load_parts.h"

namespace orbs::scene {

namespace {

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

// What tints a texture is a colour: neither says how a texel's light is spread over the wavelengths.
std::optional<TextureUse> load_tinted_texture(json::ObjectReader& in,
                                              const Names& textures,
                                              const Colour& colour) {
  if (colour.spectrum && in.has("texture"))
    in.fail("texture", "goes with a colour [r, g, b], not with a spectrum");
  return load_texture_use(in, textures);
}

MaterialModel load_basic_model(json::ObjectReader& in,
                               const std::string& type,
                               const Names& textures,
                               const SpectralData& data) {
  if (type == "glass") return Glass{in.vec3_or("colour", {1, 1, 1}, kShare), load_ior(in)};
  if (type == "rough_glass")
    return RoughGlass{in.vec3_or("colour", {1, 1, 1}, kShare), load_ior(in), load_alpha(in)};
  if (type == "ggx") {
    const auto colour = load_reflectance(in, "colour", data);
    return Ggx{colour.rgb, load_alpha(in), colour.spectrum};
  }
  if (type == "emission") {
    const auto radiance = load_radiance(in, "radiance", data);
    return Emission{radiance.rgb, load_tinted_texture(in, textures, radiance), radiance.spectrum};
  }
  const auto colour = load_reflectance(in, "reflectance", data);
  if (type == "mirror") return Mirror{colour.rgb, colour.spectrum};
  if (type == "lambert")
    return Lambert{colour.rgb, load_tinted_texture(in, textures, colour), colour.spectrum};
  return OrenNayar{colour.rgb, in.number("roughness", kShare), load_tinted_texture(in, textures, colour),
                   colour.spectrum};
}

MaterialModel load_model(json::ObjectReader& in, const Names& textures, SpectralData& data) {
  const std::string type =
      in.one_of("type", {"lambert", "oren_nayar", "mirror", "glass", "ggx", "rough_glass", "emission",
                         "conductor", "dielectric", "polariser", "retarder", "fluorescent"});
  if (type == "conductor") return load_conductor(in, data);
  if (type == "dielectric") return load_dielectric(in, data);
  if (type == "polariser") return load_polariser(in);
  if (type == "retarder") return load_retarder(in);
  if (type == "fluorescent") return load_fluorescent(in, data);
  return load_basic_model(in, type, textures, data);
}

}  // namespace

Material load_material(json::ObjectReader in, const Names& textures, SpectralData& data) {
  Material material;
  material.name = in.text("name");
  material.model = load_model(in, textures, data);
  in.finish();
  return material;
}

}  // namespace orbs::scene
