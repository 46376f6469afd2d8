#include "adapters/obj/mtl.h"

#include "adapters/exporter.h"
#include "adapters/kind_support.h"
#include "base/nth.h"

#include <fmt/format.h>

namespace orbs::adapters::obj {

namespace {

constexpr const char* kName = "OBJ";

std::string colour(const char* key, scene::RgbColour value) {
  return fmt::format("{} {} {} {}\n", key, value.x, value.y, value.z);
}

// The exponent of Phong's highlight that is about as wide as that of a microfacet distribution of this alpha
// (Walter et al. 2007, section 5.2).
double phong_exponent(double alpha) { return 2 / (alpha * alpha) - 2; }

struct MtlWriter {
  const scene::Scene& scene;
  const std::string& stem;

  std::string operator()(const scene::Lambert& m) const { return diffuse(m.reflectance, m.texture); }
  std::string operator()(const scene::OrenNayar& m) const {
    return fmt::format("# Oren-Nayar, roughness {}: MTL has Lambert's law alone, see description.json\n{}",
                       m.roughness, diffuse(m.reflectance, m.texture));
  }
  std::string operator()(const scene::Mirror& m) const {
    return "# a perfect mirror, the same share at all angles\n" + colour("Kd", {}) +
           colour("Ks", m.reflectance) + "illum 3\n";
  }
  std::string operator()(const scene::Glass& m) const {
    return "# smooth glass; Ni is inside over outside\n" + dielectric(m.colour, m.ior);
  }
  std::string operator()(const scene::RoughGlass& m) const {
    return fmt::format("# rough glass, GGX, alpha {}: MTL has smooth glass alone, see description.json\n{}",
                       m.alpha, dielectric(m.colour, m.ior));
  }
  std::string operator()(const scene::Ggx& m) const {
    return fmt::format(
        "# GGX, alpha {}, no Fresnel factor: MTL has Phong's highlight alone, see description.json\n{}{}Ns "
        "{}\nillum 2\n",
        m.alpha, colour("Kd", {}), colour("Ks", m.colour), phong_exponent(m.alpha));
  }
  std::string operator()(const scene::Emission& m) const {
    return "# emits this radiance from both sides and reflects nothing\n" + colour("Kd", {}) +
           colour("Ke", m.radiance) + "illum 0\n" + texture("map_Ke", m.texture);
  }

  std::string diffuse(scene::RgbColour reflectance, const std::optional<scene::TextureUse>& use) const {
    return colour("Kd", reflectance) + colour("Ks", {}) + "illum 1\n" + texture("map_Kd", use);
  }
  static std::string dielectric(scene::RgbColour tint, double ior) {
    return colour("Kd", {}) + colour("Tf", tint) + fmt::format("Ni {}\nillum 7\n", ior);
  }
  // MTL clamps in both directions or in none.
  std::string texture(const char* key, const std::optional<scene::TextureUse>& use) const {
    if (!use) return "";
    const auto& image = texture_at(scene, *use);
    const bool is_clamped = image.wrap_u == scene::Wrap::Clamp && image.wrap_v == scene::Wrap::Clamp;
    const bool is_mixed = image.wrap_u != image.wrap_v;
    const bool is_mirrored = image.wrap_u == scene::Wrap::Mirror || image.wrap_v == scene::Wrap::Mirror;
    const bool is_nearest = image.filter == scene::Filter::Nearest;
    const char* words = is_mirrored ? "# it is mirrored beyond its edge, see description.json\n"
                        : is_mixed  ? "# it is clamped in one direction alone, see description.json\n"
                                    : "";
    return fmt::format("{}{}{} {}{}\n", words,
                       is_nearest ? "# it is not interpolated, see description.json\n" : "", key,
                       is_clamped ? "-clamp on " : "", texture_file(scene, use->texture, stem));
  }
};

}  // namespace

std::string texture_file(const scene::Scene& scene, int texture, const std::string& stem) {
  return fmt::format("{}-texture{}{}", stem, texture, nth(scene.textures, texture).file.extension().string());
}

std::string mtl_text(const scene::Scene& scene,
                     const std::vector<std::string>& names,
                     const std::string& stem) {
  std::string text =
      "# Linear Rec.709. Kd and Ke multiply the texture. description.json has the materials in words.\n";
  for (const int index : scene::visible_materials(scene)) {
    const auto& material = material_at(scene, index);
    const MtlWriter writer{scene, stem};
    text += fmt::format("\nnewmtl {}\n{}Ka 0 0 0\n", nth(names, index),
                        text_of_material(material, kName, writer));
    const scene::SurfaceDetail& detail = material.detail;
    if (lets_rays_pass(detail))
      text += fmt::format("d {}\n{}", detail.opacity, writer.texture("map_d", detail.opacity_texture));
  }
  return text;
}

std::string material_limit(const scene::Material& material) {
  return limit_of_material<MtlWriter>(material, kName, BeyondOrbs{}, [] {});
}

}  // namespace orbs::adapters::obj
