#include "adapters/mitsuba/materials.h"

#include "adapters/detail_images.h"
#include "adapters/kind_support.h"
#include "adapters/mitsuba/xml.h"
#include "adapters/tinted_image.h"
#include "adapters/xml_comment.h"

#include <algorithm>

namespace orbs::adapters::mitsuba {

namespace {

constexpr const char* kName = "Mitsuba";
constexpr const char* kMasking = "a product of two sides";
constexpr const char* kRaw = "<boolean name=\"raw\" value=\"true\"/>";
constexpr double kLeastAlpha = 1e-4;  // its MicrofacetDistribution raises smaller ones to this

// Reflectors are one-sided in Mitsuba and two-sided in ORB.S. Both take the side from the vertex normal.
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

std::string bitmap(const char* name,
                   const std::string& file,
                   const scene::Texture& texture,
                   const std::string& more) {
  return fmt::format(
      "<texture type=\"bitmap\" name=\"{}\"><string name=\"filename\" value=\"{}\"/><string "
      "name=\"filter_type\" value=\"{}\"/><string name=\"wrap_mode\" value=\"{}\"/>{}</texture>",
      name, file, texture.filter == scene::Filter::Nearest ? "nearest" : "bilinear", word_of(texture.wrap_u),
      more);
}

struct MaterialLimits {
  const std::string& name;
  bool is_polarised = false;  // the scene is for scalar_spectral_polarized

  std::string operator()(const scene::OrenNayar& m) const {
    return oren_nayar_limit(name, m.roughness, kName);
  }
  // Light sampling on a textured emitter picks a texel and asks the mesh for the one point with these
  // coordinates: repeated or missing ones break it. With coordinates within [0, 1] the surfaces look right,
  // measured with Mitsuba 3.8.0, but the light that they cast lacks 0.5 % of scene 124's image, and the
  // scalar variants lock up where the kd-tree is built while a render thread prepares the coordinates.
  std::string operator()(const scene::Emission& m) const {
    if (!m.texture) return "";
    return fmt::format(
        "material '{}' emits through a texture: Mitsuba samples that by inverting the texture "
        "coordinates, which must then be within [0, 1] and used once, and casts too little light",
        name);
  }
  // Mitsuba's mirror is a conductor of n = 0 and k = 1: its reflectance is 1, but its phases depend on the
  // angle.
  std::string operator()(const scene::Mirror&) const { return full_mirror(); }
  std::string operator()(const scene::Ggx& m) const {
    const std::string reason = rough(m.alpha);
    return reason.empty() ? full_mirror() : reason;
  }
  std::string operator()(const scene::RoughGlass& m) const {
    const std::string reason = rough(m.alpha);
    return reason.empty() ? rough_glass() : reason;
  }
  std::string operator()(const scene::AnisotropicGgx& m) const {
    if (const auto reason = rotation_limit(name, m, kName); !reason.empty()) return reason;
    if (const auto reason = full_mirror(); !reason.empty()) return reason;
    if (const auto reason = alpha_limit(name, std::min(m.alpha_x, m.alpha_y), kName, kLeastAlpha);
        !reason.empty())
      return reason;
    return masking_limit(name, {std::max(m.alpha_x, m.alpha_y), scene::Distribution::Ggx, m.masking}, kName,
                         true);
  }
  std::string operator()(const scene::VaryingGgx& m) const {
    if (const auto reason = full_mirror(); !reason.empty()) return reason;
    return masking_limit(name, {m.alpha, scene::Distribution::Ggx, m.masking}, kName, true);
  }
  std::string operator()(const scene::GgxLambert& m) const {
    const std::string reason = mix_limit(name, m, kName);
    return reason.empty() ? rough(m.alpha) : reason;
  }
  std::string operator()(const scene::Plastic& m) const {
    return m.alpha ? alpha_limit(name, *m.alpha, kName, kLeastAlpha) : "";
  }
  std::string operator()(const scene::Conductor& m) const { return m.roughness ? rough(*m.roughness) : ""; }
  std::string operator()(const scene::Dielectric& m) const {
    if (!m.roughness) return "";
    const std::string reason = rough(*m.roughness);
    return reason.empty() ? rough_glass() : reason;
  }
  // Mitsuba's retarder.cpp multiplies the retardance by the cosine of the angle.
  std::string operator()(const scene::Retarder& m) const {
    return fmt::format(
        "material '{}' retards by {} degrees at all angles: Mitsuba's retarder falls off with the cosine "
        "of the angle of incidence",
        name, m.retardance_deg);
  }

  std::string rough(double alpha) const {
    const std::string reason = alpha_limit(name, alpha, kName, kLeastAlpha);
    return reason.empty() ? masking_limit(name, alpha, kName, kMasking) : reason;
  }
  std::string rough(const scene::Roughness& roughness) const {
    const std::string reason = alpha_limit(name, roughness.alpha, kName, kLeastAlpha);
    return reason.empty() ? masking_limit(name, roughness, kName, true) : reason;
  }
  std::string rough_glass() const {
    if (!is_polarised) return "";
    return fmt::format("material '{}' is rough glass in polarised light: Mitsuba's forgets the polarisation",
                       name);
  }
  std::string full_mirror() const {
    if (!is_polarised) return "";
    return fmt::format(
        "material '{}' is a full mirror in polarised light: Mitsuba's shifts the phases of both "
        "polarisations as a metal would",
        name);
  }
};

struct BsdfWriter {
  const Colours& colours;
  const std::string& id;
  const std::string& image;

  std::string diffuse(scene::RgbColour reflectance,
                      const std::optional<scene::SpectrumUse>& spectrum,
                      const std::optional<scene::TextureUse>& use) const {
    return two_sided(id, fmt::format("<bsdf type=\"diffuse\">{}</bsdf>",
                                     reflectance_or_image("reflectance", reflectance, spectrum, use)));
  }
  std::string reflectance_or_image(const char* parameter,
                                   scene::RgbColour reflectance,
                                   const std::optional<scene::SpectrumUse>& spectrum,
                                   const std::optional<scene::TextureUse>& use) const {
    if (!use) return colours.surface(parameter, reflectance, spectrum);
    return bitmap(parameter, image, texture_at(colours.scene, *use), "");
  }
  // The parameters that both types of glass share. Mitsuba's default for the outside is air, 1.000277.
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
  // MaterialLimits let it through with roughness 0 only, and there it is Lambert's law.
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
  // MaterialLimits let it through with quarters alone. Mitsuba's u is the direction of increasing u, too.
  std::string operator()(const scene::AnisotropicGgx& m) const {
    const auto [along, across] = scene::alphas_unturned(m).value();
    return two_sided(
        id, fmt::format("<bsdf type=\"roughconductor\"><string name=\"material\" value=\"none\"/><string "
                        "name=\"distribution\" value=\"ggx\"/><float name=\"alpha_u\" value=\"{}\"/><float "
                        "name=\"alpha_v\" value=\"{}\"/>{}</bsdf>",
                        along, across, colours.surface("specular_reflectance", m.colour, m.spectrum)));
  }
  std::string operator()(const scene::VaryingGgx& m) const {
    return two_sided(
        id, fmt::format("<bsdf type=\"roughconductor\"><string name=\"material\" value=\"none\"/><string "
                        "name=\"distribution\" value=\"ggx\"/>{}{}</bsdf>",
                        bitmap("alpha", image, texture_at(colours.scene, *m.texture), kRaw),
                        colours.surface("specular_reflectance", m.colour, m.spectrum)));
  }
  // The parts stand before the blend and have their sides themselves.
  std::string operator()(const scene::Blend& m) const {
    return fmt::format(
        "<bsdf type=\"blendbsdf\" id=\"{}\">{}<ref id=\"material{}\"/><ref id=\"material{}\"/></bsdf>\n", id,
        m.texture ? bitmap("weight", image, texture_at(colours.scene, *m.texture), kRaw)
                  : fmt::format("<float name=\"weight\" value=\"{}\"/>", m.weight),
        m.parts[0].material, m.parts[1].material);
  }
  std::string operator()(const scene::GgxLambert& m) const {
    const auto mean = scene::mix_as_mean(m);
    return two_sided(
        id, fmt::format("<bsdf type=\"blendbsdf\"><float name=\"weight\" value=\"{}\"/><bsdf "
                        "type=\"roughconductor\"><string name=\"material\" value=\"none\"/>{}{}</bsdf><bsdf "
                        "type=\"diffuse\">{}</bsdf></bsdf>",
                        mean.weight, ggx(m.alpha), colours.surface("specular_reflectance", mean.glossy),
                        colours.surface("reflectance", mean.diffuse)));
  }
  // One-sided as its reflectors are.
  std::string operator()(const scene::Plastic& m) const {
    return two_sided(
        id,
        fmt::format("<bsdf type=\"{}\"><float name=\"int_ior\" value=\"{}\"/><float name=\"ext_ior\" "
                    "value=\"1\"/><boolean name=\"nonlinear\" value=\"{}\"/>{}{}</bsdf>",
                    m.alpha ? "roughplastic" : "plastic", m.ior, m.is_nonlinear, m.alpha ? ggx(*m.alpha) : "",
                    reflectance_or_image("diffuse_reflectance", m.reflectance, m.spectrum, m.texture)));
  }
  // Conductors are one-sided in both renderers: black from behind. Mitsuba has no index for the outside of a
  // conductor.
  std::string operator()(const scene::Conductor& m) const {
    return fmt::format("<bsdf type=\"{}\" id=\"{}\">{}{}{}</bsdf>\n",
                       m.roughness ? "roughconductor" : "conductor", id, spectrum("eta", samples_of_n(m)),
                       spectrum("k", samples_of_k(m)), m.roughness ? roughness(*m.roughness) : "");
  }
  // MaterialLimits let it through with one ratio for all wavelengths only.
  std::string operator()(const scene::Dielectric& m) const {
    constexpr double kAnywhere_nm = 550;
    return dielectric(m.roughness ? "roughdielectric" : "dielectric", index_at(m.index, kAnywhere_nm),
                      index_at(m.outside, kAnywhere_nm), m.roughness ? roughness(*m.roughness) : "");
  }
  // The axis is given by the texture coordinates of the shapes. At oblique incidence Mitsuba projects the
  // absorbing axis across the ray, we the transmitting one: in the corners of an image of 34 degrees these
  // are 4.9 degrees apart, which lets 0.7 % of crossed light through.
  std::string operator()(const scene::Polariser&) const {
    return fmt::format("<bsdf type=\"polarizer\" id=\"{}\"/>\n", id);
  }
};

}  // namespace

const BeyondOrbs& beyond_orbs() {
  static const BeyondOrbs kLevels{
      {"B2", "B3", "B4", "B5", "B6", "B9", "C1", "C2", "C3", "D1", "D2", "D3",
       "D5", "D6", "E1", "E2", "E3", "N1", "N2", "N3", "N4", "N5", "N6", "V1"},
      {{"B1", "Mitsuba's rough metals follow n and k and are masked by the separable term"},
       {"B7", "Mitsuba's principled BSDF is another model"},
       {"B8", "Mitsuba 3 has no Phong reflection"},
       {"C4", "Mitsuba 3 has no latitude-longitude camera"},
       {"D4", "Mitsuba has no light with a measured intensity distribution"},
       {"E4", "Mitsuba has no fluorescence"},
       {"E5", "Mitsuba has no thin films"},
       {"E6", "Mitsuba's dielectrics have one index for all wavelengths"},
       {"S7", "a plug-in is machine code for the built-in tracer"},
       {"T1", "Mitsuba 3 has no shapes that move"},
       {"T2", "Mitsuba 3 has no meshes that change their shape"},
       {"T3", "Mitsuba 3 has no cameras that move"}}};
  return kLevels;
}

namespace {

// By default Mitsuba turns normals that face away from the viewer, and darkens surfaces by a term for
// shadows. What has two sides stands inside: from behind, the bumps are dents then, and no mirror images.
std::string turned(const char* type, const std::string& id, const std::string& map, const std::string& even) {
  return fmt::format(
      "<bsdf type=\"{}\" id=\"{}\"><boolean name=\"flip_invalid_normals\" value=\"false\"/><boolean "
      "name=\"use_shadowing_function\" value=\"false\"/>{}\n{}</bsdf>\n",
      type, id, map, even);
}

}  // namespace

std::string material_limit(const scene::Material& material, bool is_polarised) {
  return limit_of_material<BsdfWriter>(material, kName, beyond_orbs(),
                                       MaterialLimits{material.name, is_polarised});
}

std::string bsdf_id(int material, bool is_mirrored) {
  return fmt::format("material{}{}", material, is_mirrored ? "-mirrored" : "");
}

std::string bsdf_text(const Colours& colours, int material, const std::string& stem, bool is_mirrored) {
  const auto& m = material_at(colours.scene, material);
  const std::string name = bsdf_id(material, is_mirrored);
  const bool is_open = lets_rays_pass(m.detail);
  const std::string whole_id = is_open ? name + "-whole" : name;
  const std::string even_id = turns_normals(m.detail) ? name + "-even" : whole_id;
  const std::string image = tinted_image_name(material, stem);
  auto whole = text_of_material(m, kName, BsdfWriter{colours, even_id, image});
  const auto map_of = [&](const char* parameter, const std::string& file, const scene::TextureUse& use) {
    return bitmap(parameter, file, texture_at(colours.scene, use), kRaw);
  };
  if (const auto& map = m.detail.bump_map)
    whole = turned("bumpmap", whole_id, map_of("heights", height_image_name(material, stem), map->texture),
                   whole);
  if (const auto& map = m.detail.normal_map)
    whole = turned("normalmap", whole_id,
                   map_of("normalmap", normal_image_name(material, stem, is_mirrored), map->texture), whole);
  if (!is_open) return xml_comment(m.name) + whole;
  const auto& use = m.detail.opacity_texture;
  const auto opacity = use ? map_of("opacity", opacity_image_name(material, stem), *use)
                           : fmt::format("<float name=\"opacity\" value=\"{}\"/>", m.detail.opacity);
  return xml_comment(m.name) +
         fmt::format("<bsdf type=\"mask\" id=\"{}\">{}\n{}</bsdf>\n", name, opacity, whole);
}

}  // namespace orbs::adapters::mitsuba
