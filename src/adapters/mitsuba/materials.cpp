#include "adapters/mitsuba/materials.h"

#include "adapters/mitsuba/xml.h"

namespace orbs::adapters::mitsuba {

namespace {

// All reflectors are one-sided in Mitsuba, ORB.S's are not. The side is that of the vertex normal in both.
std::string two_sided(const std::string& id, const std::string& inner) {
  return fmt::format("<bsdf type=\"twosided\" id=\"{}\">{}</bsdf>\n", id, inner);
}

struct BsdfWriter {
  const scene::Scene& scene;
  const std::string& id;
  const std::string& picture;

  std::string diffuse(scene::Rgb reflectance, const std::optional<scene::TextureUse>& use) const {
    if (!use)
      return two_sided(id, fmt::format("<bsdf type=\"diffuse\">{}</bsdf>", rgb("reflectance", reflectance)));
    const scene::Texture& texture = scene.textures[static_cast<std::size_t>(use->texture)];
    return two_sided(
        id, fmt::format("<bsdf type=\"diffuse\"><texture type=\"bitmap\" name=\"reflectance\"><string "
                        "name=\"filename\" value=\"{}\"/><string name=\"filter_type\" value=\"bilinear\"/>"
                        "<string name=\"wrap_mode\" value=\"{}\"/></texture></bsdf>",
                        picture, texture.wrap_u == scene::Wrap::Clamp ? "clamp" : "repeat"));
  }
  // `type` with the parameters of both sorts of glass. Outside is vacuum: Mitsuba's default is air, 1.000277.
  std::string dielectric(const char* type, scene::Rgb colour, double ior, const std::string& more) const {
    return fmt::format(
        "<bsdf type=\"{}\" id=\"{}\"><float name=\"int_ior\" value=\"{}\"/><float name=\"ext_ior\" "
        "value=\"1\"/>{}{}{}</bsdf>\n",
        type, id, ior, more, rgb("specular_reflectance", colour), rgb("specular_transmittance", colour));
  }
  // Mitsuba's default distribution is Beckmann's.
  static std::string ggx(double alpha) {
    return fmt::format("<string name=\"distribution\" value=\"ggx\"/><float name=\"alpha\" value=\"{}\"/>",
                       alpha);
  }

  std::string operator()(const scene::Lambert& m) const { return diffuse(m.reflectance, m.texture); }
  // mitsuba_limits lets it through with roughness 0 only, and there it is Lambert's law.
  std::string operator()(const scene::OrenNayar& m) const { return diffuse(m.reflectance, m.texture); }
  std::string operator()(const scene::Emission&) const { return diffuse({}, {}); }
  // Material "none" reflects everything at all angles; its Fresnel factor is 1.
  std::string operator()(const scene::Mirror& m) const {
    return two_sided(id, fmt::format("<bsdf type=\"conductor\"><string name=\"material\" value=\"none\"/>"
                                     "{}</bsdf>",
                                     rgb("specular_reflectance", m.reflectance)));
  }
  std::string operator()(const scene::Ggx& m) const {
    return two_sided(id, fmt::format("<bsdf type=\"roughconductor\"><string name=\"material\" "
                                     "value=\"none\"/>{}{}</bsdf>",
                                     ggx(m.alpha), rgb("specular_reflectance", m.colour)));
  }
  std::string operator()(const scene::Glass& m) const {
    return dielectric("dielectric", m.colour, m.ior, "");
  }
  std::string operator()(const scene::RoughGlass& m) const {
    return dielectric("roughdielectric", m.colour, m.ior, ggx(m.alpha));
  }
  // mitsuba_limits lets none through that anything shows.
  std::string operator()(const scene::AppearanceModel auto&) const { return diffuse({}, {}); }
};

}  // namespace

std::string picture_name(int material, const std::string& stem) {
  return fmt::format("{}-material{}.exr", stem, material);
}

std::string bsdf_text(const scene::Scene& scene, int material, const std::string& stem) {
  const auto& m = scene.materials[static_cast<std::size_t>(material)];
  const std::string id = fmt::format("material{}", material);
  return comment(m.name) + std::visit(BsdfWriter{scene, id, picture_name(material, stem)}, m.model);
}

}  // namespace orbs::adapters::mitsuba
