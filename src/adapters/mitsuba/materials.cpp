#include "adapters/mitsuba/materials.h"

#include "adapters/mitsuba/xml.h"
#include "adapters/tinted_image.h"

namespace orbs::adapters::mitsuba {

namespace {

// All reflectors are one-sided in Mitsuba, ORB.S's are not. The side is that of the vertex normal in both.
std::string two_sided(const std::string& id, const std::string& inner) {
  return fmt::format("<bsdf type=\"twosided\" id=\"{}\">{}</bsdf>\n", id, inner);
}

// Mitsuba's default distribution is Beckmann's.
std::string roughness(double alpha, const char* distribution) {
  return fmt::format("<string name=\"distribution\" value=\"{}\"/><float name=\"alpha\" value=\"{}\"/>",
                     distribution, alpha);
}

std::string ggx(double alpha) { return roughness(alpha, "ggx"); }

std::string roughness(const scene::Roughness& r) {
  return roughness(r.alpha, r.distribution == scene::Distribution::Ggx ? "ggx" : "beckmann");
}

struct BsdfWriter {
  const Colours& colours;
  const std::string& id;
  const std::string& image;

  std::string diffuse(scene::RgbColour reflectance,
                      const std::optional<scene::SpectrumUse>& spectrum,
                      const std::optional<scene::TextureUse>& use) const {
    if (!use)
      return two_sided(id, fmt::format("<bsdf type=\"diffuse\">{}</bsdf>",
                                       colours.surface("reflectance", reflectance, spectrum)));
    const scene::Texture& texture = colours.scene.textures[static_cast<std::size_t>(use->texture)];
    return two_sided(
        id, fmt::format("<bsdf type=\"diffuse\"><texture type=\"bitmap\" name=\"reflectance\"><string "
                        "name=\"filename\" value=\"{}\"/><string name=\"filter_type\" "
                        "value=\"bilinear\"/><string name=\"wrap_mode\" value=\"{}\"/></texture></bsdf>",
                        image, texture.wrap_u == scene::Wrap::Clamp ? "clamp" : "repeat"));
  }
  // `type` with the parameters of both sorts of glass. Mitsuba's default for outside is air, 1.000277.
  std::string dielectric(const char* type, double inside, double outside, const std::string& more) const {
    return fmt::format(
        "<bsdf type=\"{}\" id=\"{}\"><float name=\"int_ior\" value=\"{}\"/><float name=\"ext_ior\" "
        "value=\"{}\"/>{}</bsdf>\n",
        type, id, inside, outside, more);
  }
  std::string tinted(scene::RgbColour colour) const {
    return colours.surface("specular_reflectance", colour) +
           colours.surface("specular_transmittance", colour);
  }

  std::string operator()(const scene::Lambert& m) const {
    return diffuse(m.reflectance, m.spectrum, m.texture);
  }
  // mitsuba_limits lets it through with roughness 0 only, and there it is Lambert's law.
  std::string operator()(const scene::OrenNayar& m) const {
    return diffuse(m.reflectance, m.spectrum, m.texture);
  }
  std::string operator()(const scene::Emission&) const { return diffuse({}, {}, {}); }
  // Material "none" reflects everything at all angles; its Fresnel factor is 1.
  std::string operator()(const scene::Mirror& m) const {
    return two_sided(id, fmt::format("<bsdf type=\"conductor\"><string name=\"material\" "
                                     "value=\"none\"/>{}</bsdf>",
                                     colours.surface("specular_reflectance", m.reflectance, m.spectrum)));
  }
  std::string operator()(const scene::Ggx& m) const {
    return two_sided(
        id, fmt::format("<bsdf type=\"roughconductor\"><string name=\"material\" "
                        "value=\"none\"/>{}{}</bsdf>",
                        ggx(m.alpha), colours.surface("specular_reflectance", m.colour, m.spectrum)));
  }
  std::string operator()(const scene::Glass& m) const {
    return dielectric("dielectric", m.ior, 1, tinted(m.colour));
  }
  std::string operator()(const scene::RoughGlass& m) const {
    return dielectric("roughdielectric", m.ior, 1, ggx(m.alpha) + tinted(m.colour));
  }
  // One-sided in both: black from behind. Mitsuba has no index for what is outside of a conductor.
  std::string operator()(const scene::Conductor& m) const {
    return fmt::format("<bsdf type=\"{}\" id=\"{}\">{}{}{}</bsdf>\n",
                       m.roughness ? "roughconductor" : "conductor", id, spectrum("eta", samples_of_n(m)),
                       spectrum("k", samples_of_k(m)), m.roughness ? roughness(*m.roughness) : "");
  }
  // mitsuba_limits lets it through with one ratio for all wavelengths only.
  std::string operator()(const scene::Dielectric& m) const {
    constexpr double kAnywhere_nm = 550;
    return dielectric(m.roughness ? "roughdielectric" : "dielectric", index_at(m.index, kAnywhere_nm),
                      index_at(m.outside, kAnywhere_nm), m.roughness ? roughness(*m.roughness) : "");
  }
  // The axis stands with the shapes, as their texture coordinates. Of light that crosses at a slant Mitsuba
  // projects the absorbing axis across the ray, we the transmitting one: in the corners of an image of 34
  // degrees these are 4.9 degrees apart, which lets 0.7 % of crossed light through.
  std::string operator()(const scene::Polariser&) const {
    return fmt::format("<bsdf type=\"polarizer\" id=\"{}\"/>\n", id);
  }
  // mitsuba_limits lets none through that anything shows.
  std::string operator()(const scene::Retarder&) const { return diffuse({}, {}, {}); }
  std::string operator()(const scene::Fluorescent&) const { return diffuse({}, {}, {}); }
};

}  // namespace

std::string bsdf_text(const Colours& colours, int material, const std::string& stem) {
  const auto& m = colours.scene.materials[static_cast<std::size_t>(material)];
  const std::string id = fmt::format("material{}", material);
  return comment(m.name) + std::visit(BsdfWriter{colours, id, tinted_image_name(material, stem)}, m.model);
}

}  // namespace orbs::adapters::mitsuba
