#include "adapters/pbrt/materials.h"

#include "adapters/detail_images.h"
#include "adapters/exporter.h"
#include "adapters/kind_support.h"
#include "adapters/mirrored_image.h"
#include "adapters/pbrt/colours.h"
#include "adapters/pbrt/directives.h"
#include "adapters/tinted_image.h"

#include <algorithm>
#include <array>

namespace orbs::adapters::pbrt {

namespace {

constexpr const char* kName = "pbrt";
constexpr const char* kMasking = "height-correlated in transmission, too";
constexpr double kLeastAlpha = 1e-3;  // its distribution takes smaller ones for smooth

struct MaterialLimits {
  const std::string& name;

  std::string operator()(const scene::Conductor& m) const { return m.roughness ? rough(*m.roughness) : ""; }
  std::string operator()(const scene::Dielectric& m) const { return m.roughness ? rough(*m.roughness) : ""; }
  std::string operator()(const scene::AnisotropicGgx& m) const {
    if (const auto reason = rotation_limit(name, m, kName); !reason.empty()) return reason;
    if (const auto reason = alpha_limit(name, std::min(m.alpha_x, m.alpha_y), kName, kLeastAlpha);
        !reason.empty())
      return reason;
    if (const auto reason = masking_limit(
            name, {std::max(m.alpha_x, m.alpha_y), scene::Distribution::Ggx, m.masking}, kName, false);
        !reason.empty())
      return reason;
    return coloured(m.colour, "glossy reflector");
  }
  std::string operator()(const scene::VaryingGgx& m) const {
    const auto reason = masking_limit(name, {m.alpha, scene::Distribution::Ggx, m.masking}, kName, false);
    return reason.empty() ? coloured(m.colour, "glossy reflector") : reason;
  }
  std::string operator()(const scene::GgxLambert& m) const {
    if (const auto reason = mix_limit(name, m, kName); !reason.empty()) return reason;
    if (const auto reason = alpha_limit(name, m.alpha, kName, kLeastAlpha); !reason.empty()) return reason;
    return coloured(scene::mixed_colours(m).glossy, "glossy reflector");
  }
  std::string operator()(const scene::Plastic& m) const {
    if (m.is_nonlinear) return "";
    return fmt::format(
        "material '{}' is plastic in which light keeps its colour: in pbrt's coat it takes that of the base "
        "each time",
        name);
  }
  std::string operator()(const scene::OrenNayar& m) const {
    return oren_nayar_limit(name, m.roughness, kName);
  }
  std::string operator()(const scene::Emission& m) const {
    if (!m.texture) return "";
    return fmt::format(
        "material '{}' emits through a texture: pbrt's area light keeps a copy of the image for each "
        "triangle, never repeats it and changes its colours",
        name);
  }
  std::string operator()(const scene::Mirror& m) const { return coloured(m.reflectance, "mirror"); }
  std::string operator()(const scene::Ggx& m) const {
    const std::string reason = alpha_limit(name, m.alpha, kName, kLeastAlpha);
    return reason.empty() ? coloured(m.colour, "glossy reflector") : reason;
  }
  std::string operator()(const scene::Glass& m) const { return tinted(m.colour); }
  std::string operator()(const scene::RoughGlass& m) const {
    if (const auto reason = alpha_limit(name, m.alpha, kName, kLeastAlpha); !reason.empty()) return reason;
    if (const auto reason = masking_limit(name, m.alpha, kName, kMasking); !reason.empty()) return reason;
    return tinted(m.colour);
  }

  std::string rough(const scene::Roughness& roughness) const {
    if (roughness.distribution != scene::Distribution::Ggx)
      return fmt::format("material '{}' has Beckmann's distribution: pbrt has GGX alone", name);
    const std::string reason = alpha_limit(name, roughness.alpha, kName, kLeastAlpha);
    return reason.empty() ? masking_limit(name, roughness, kName, false) : reason;
  }
  std::string coloured(scene::RgbColour colour, const char* what) const {
    if (scene::is_grey(colour)) return "";
    return fmt::format(
        "material '{}' is a coloured {}: pbrt's reflectance of metals depends on the angle, and the "
        "share of a full mirror that stands for a constant one has no colour",
        name, what);
  }
  std::string tinted(scene::RgbColour colour) const {
    if (colour == scene::RgbColour{1, 1, 1}) return "";
    return fmt::format("material '{}' is tinted glass: pbrt's dielectrics have no colour", name);
  }
};

// The files hold floats, which pbrt takes as they are.
std::string image_texture(const std::string& name, const std::string& file, const scene::Texture& texture) {
  const Vec2d scale = unmirrored_uv_scale(texture);
  const auto scales =
      is_mirrored(texture) ? fmt::format(" \"float uscale\" {} \"float vscale\" {}", scale.x, scale.y) : "";
  return fmt::format(
      "Texture \"{}\" \"float\" \"imagemap\" \"string filename\" \"{}\" \"string filter\" "
      "\"{}\" \"string wrap\" \"{}\"{}\n",
      name, file, texture.filter == scene::Filter::Nearest ? "point" : "bilinear",
      word_of(unmirrored(texture).wrap_u), scales);
}

std::string opacity_name(int material) { return fmt::format("material{}-opacity", material); }
std::string heights_name(int material) { return fmt::format("material{}-heights", material); }

struct MaterialWriter {
  const Colours& colours;
  const std::string& name;
  const std::string& stem;  // of the scene file
  int material = 0;
  std::string detail = "";  // parameters that all but mixes have

  std::string named(const std::string& of, const std::string& type, const std::string& parameters) const {
    return fmt::format("MakeNamedMaterial \"{}\" \"string type\" \"{}\" {}{}\n", of, type, parameters,
                       type == "mix" ? "" : detail);
  }
  std::string diffuse(scene::RgbColour reflectance,
                      const std::optional<scene::SpectrumUse>& spectrum,
                      const std::optional<scene::TextureUse>& use) const {
    return textures_of(use) + named(name, "diffuse", reflectance_or_texture(reflectance, spectrum, use));
  }
  std::string textures_of(const std::optional<scene::TextureUse>& use) const {
    return use ? textures(texture_at(colours.scene, *use)) : "";
  }
  std::string reflectance_or_texture(scene::RgbColour reflectance,
                                     const std::optional<scene::SpectrumUse>& spectrum,
                                     const std::optional<scene::TextureUse>& use) const {
    return use ? fmt::format("\"texture reflectance\" \"{}-texture\"", name)
               : colours.surface("reflectance", reflectance, spectrum);
  }
  // pbrt's v runs up from the bottom row, as ours.
  std::string textures(const scene::Texture& texture) const {
    const auto files = tinted_channel_names(material, stem);
    const std::array images{name + "-image-r", name + "-image-g", name + "-image-b"};
    std::string text;
    for (std::size_t c = 0; c < images.size(); ++c) text += image_texture(images[c], files[c], texture);
    return text + band_texture(name + "-texture", images);
  }
  // The reflectance of pbrt's conductors grows towards grazing angles, that of ORB.S's mirrors is the same at
  // all. So a share of the hits meets a full mirror and the rest a black surface, which is right on average
  // for a grey colour. pbrt's full mirror has a reflectance of 0.9999 (k = 200 with eta 1); over all angles,
  // weighted by the cosine, it lacks 16 / (3 k^2) = 1.3e-4.
  std::string share_of_full(double share, const std::string& roughness) const {
    return named(name + "-none", "diffuse", rgb("reflectance", {})) +
           named(name + "-full", "conductor", rgb("reflectance", {1, 1, 1}) + roughness) +
           named(name, "mix",
                 fmt::format("\"string materials\" [\"{0}-none\" \"{0}-full\"] \"float amount\" {1}", name,
                             share));
  }
  std::string operator()(const scene::AnisotropicGgx& m) const {
    const auto [along, across] = scene::alphas_unturned(m).value();
    return share_of_full(
        m.colour.x,
        fmt::format(" \"float uroughness\" {} \"float vroughness\" {} \"bool remaproughness\" false", along,
                    across));
  }
  // Of the images of the three channels, which hold the same, the first.
  std::string operator()(const scene::VaryingGgx& m) const {
    return textures_of(m.texture) +
           share_of_full(
               m.colour.x,
               fmt::format(" \"texture roughness\" \"{}-image-r\" \"bool remaproughness\" false", name));
  }
  // The parts stand before the blend.
  std::string operator()(const scene::Blend& m) const {
    const std::string amount = m.texture ? fmt::format("\"texture amount\" \"{}-image-r\"", name)
                                         : fmt::format("\"float amount\" {}", m.weight);
    return textures_of(m.texture) +
           named(name, "mix",
                 fmt::format("\"string materials\" [\"material{}\" \"material{}\"] {}", m.parts[0].material,
                             m.parts[1].material, amount));
  }
  std::string operator()(const scene::GgxLambert& m) const {
    const auto mean = scene::mix_as_mean(m);
    const std::string glossy = name + "-glossy";
    const MaterialWriter part{colours, glossy, stem, material, detail};
    return part.share_of_full(mean.glossy.x, ggx(m.alpha)) +
           named(name + "-diffuse", "diffuse", rgb("reflectance", mean.diffuse)) +
           named(name, "mix",
                 fmt::format("\"string materials\" [\"{0}-glossy\" \"{0}-diffuse\"] \"float amount\" {1}",
                             name, mean.weight));
  }
  // Without remapping, pbrt's roughness is alpha.
  static std::string ggx(double alpha) {
    return fmt::format(" \"float roughness\" {} \"bool remaproughness\" false", alpha);
  }

  std::string operator()(const scene::Lambert& m) const {
    return diffuse(m.reflectance, m.spectrum, m.texture);
  }
  // MaterialLimits let it through with roughness 0 only, and there it is Lambert's law.
  std::string operator()(const scene::OrenNayar& m) const {
    return diffuse(m.reflectance, m.spectrum, m.texture);
  }
  std::string operator()(const scene::Emission&) const { return diffuse({}, {}, {}); }
  std::string operator()(const scene::Mirror& m) const {
    return share_of_full(m.reflectance.x, " \"float roughness\" 0");
  }
  std::string operator()(const scene::Ggx& m) const { return share_of_full(m.colour.x, ggx(m.alpha)); }
  std::string operator()(const scene::Glass& m) const {
    return named(name, "dielectric", fmt::format("\"float eta\" {} \"float roughness\" 0", m.ior));
  }
  std::string operator()(const scene::RoughGlass& m) const {
    return named(name, "dielectric", fmt::format("\"float eta\" {}{}", m.ior, ggx(m.alpha)));
  }
  // Light walks at random between the boundary and the base. A walk of 100 ends long after all light that
  // floats hold has left; the coat absorbs exp(-thickness / cos) on each way, by default 1 % at the least.
  std::string operator()(const scene::Plastic& m) const {
    return textures_of(m.texture) +
           named(
               name, "coateddiffuse",
               reflectance_or_texture(m.reflectance, m.spectrum, m.texture) +
                   fmt::format(
                       " \"float eta\" {} \"float roughness\" 0 \"integer maxdepth\" 100 \"float thickness\" 1e-7",
                       m.ior));
  }
  // pbrt has no index for the outside of a conductor.
  std::string operator()(const scene::Conductor& m) const {
    return named(name, "conductor",
                 fmt::format("{} {}{}", spectrum("eta", samples_of_n(m)), spectrum("k", samples_of_k(m)),
                             m.roughness ? ggx(m.roughness->alpha) : " \"float roughness\" 0"));
  }
  // With a spectrum as index, pbrt terminates the secondary wavelengths; with a number it does not.
  std::string operator()(const scene::Dielectric& m) const {
    const Samples eta = samples_of_ratio(m.index, m.outside);
    return named(name, "dielectric",
                 (is_dispersive(m) ? spectrum("eta", eta) : fmt::format("\"float eta\" {}", eta.front())) +
                     (m.roughness ? ggx(m.roughness->alpha) : " \"float roughness\" 0"));
  }
};

}  // namespace

const BeyondOrbs& beyond_orbs() {
  static const BeyondOrbs kLevels{
      {"B2", "B3", "B4", "B6", "B9", "C1", "C2", "C3", "C4", "D1", "D2",
       "D3", "D4", "E1", "E2", "E6", "N1", "N2", "N3", "N4", "N5", "N6"},
      {{"B1", "pbrt's metals follow n and k, not Schlick's formula"},
       {"B5", "pbrt's rough coat is walked through at random and has another dependence on the angle"},
       {"B7", "pbrt has no material of metallic and roughness"},
       {"B8", "pbrt has no Phong reflection"},
       {"D5",
        "pbrt multiplies the colours of a sky's image by the spectrum of daylight: even a grey one is 0.83, 1.02 "
        "and 1.06 in red, green and blue"},
       {"D6", "pbrt's camera sees all that shines"},
       {"E3", "pbrt carries no polarisation"},
       {"E4", "pbrt has no fluorescence"},
       {"E5", "pbrt has no thin films"},
       {"S7", "a plug-in is machine code for the built-in tracer"},
       {"T1", "pbrt interpolates rotation, stretch and translation, not the entries of matrices"},
       {"T2", "pbrt has no meshes that change their shape"},
       {"T3", "pbrt interpolates rotation, stretch and translation, not the vectors of a camera"},
       {"V1", "pbrt's film of layers has no spectral bands, by which the exporter hands it colours"}}};
  return kLevels;
}

std::string material_limit(const scene::Material& material) {
  return limit_of_material<MaterialWriter>(material, kName, beyond_orbs(), MaterialLimits{material.name});
}

std::string alpha_text(const scene::Material& material, int index) {
  const scene::SurfaceDetail& detail = material.detail;
  if (detail.opacity_texture) return fmt::format(" \"texture alpha\" \"{}\"", opacity_name(index));
  return detail.opacity < 1 ? fmt::format(" \"float alpha\" {}", detail.opacity) : "";
}

std::string material_name(int material, bool is_mirrored) {
  return fmt::format("material{}{}", material, is_mirrored ? "-mirrored" : "");
}

std::string material_text(const Colours& colours, int material, const std::string& stem, bool is_mirrored) {
  const auto& m = material_at(colours.scene, material);
  std::string text = fmt::format("# material {}\n", comment_text(m.name));
  if (const auto& use = m.detail.opacity_texture; use && !is_mirrored)
    text += image_texture(opacity_name(material), opacity_image_name(material, stem),
                          texture_at(colours.scene, *use));
  std::string detail;
  if (const auto& map = m.detail.bump_map) {
    text += image_texture(heights_name(material), height_image_name(material, stem),
                          texture_at(colours.scene, map->texture));
    detail = fmt::format(" \"texture displacement\" \"{}\"", heights_name(material));
  }
  if (m.detail.normal_map)
    detail = fmt::format(" \"string normalmap\" \"{}\"", normal_image_name(material, stem, is_mirrored));
  const std::string name = material_name(material, is_mirrored);
  return text + text_of_material(m, kName, MaterialWriter{colours, name, stem, material, detail});
}

}  // namespace orbs::adapters::pbrt
