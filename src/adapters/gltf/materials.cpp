#include "adapters/gltf/materials.h"

#include "adapters/kind_support.h"

#include <cmath>

#include <fmt/format.h>

namespace orbs::adapters::gltf {

namespace {

constexpr const char* kName = "glTF";
constexpr const char* kMasking = "a product of two sides";  // appendix B.3.2 of the specification

struct MaterialLimits {
  const std::string& name;

  std::string operator()(const scene::OrenNayar& m) const {
    return oren_nayar_limit(name, m.roughness, kName);
  }
  std::string operator()(const scene::Mirror& m) const { return coloured(m.reflectance, "mirror"); }
  std::string operator()(const scene::Ggx& m) const {
    const std::string reason = masking_limit(name, m.alpha, kName, kMasking);
    return reason.empty() ? coloured(m.colour, "glossy reflector") : reason;
  }
  std::string operator()(const scene::Glass& m) const { return glass(m.colour, m.ior); }
  std::string operator()(const scene::RoughGlass& m) const {
    const std::string reason = masking_limit(name, m.alpha, kName, kMasking);
    return reason.empty() ? glass(m.colour, m.ior) : reason;
  }

  std::string coloured(scene::RgbColour colour, const char* what) const {
    if (scene::is_grey(colour)) return "";
    return fmt::format(
        "material '{}' is a coloured {}: glTF's colours of reflections turn grey towards grazing angles",
        name, what);
  }
  std::string glass(scene::RgbColour colour, double ior) const {
    if (colour != scene::RgbColour{1, 1, 1})
      return fmt::format(
          "material '{}' is tinted glass: glTF's colour acts on what glass lets through, not "
          "on what it reflects",
          name);
    if (ior < 1) return fmt::format("material '{}' has the index {}: glTF has none below 1", name, ior);
    return "";
  }
};

struct SurfaceWriter {
  static Surface diffuse(scene::RgbColour reflectance) { return {.base_colour = reflectance}; }
  static Surface glass(double ior, double roughness) {
    return {.base_colour = {1, 1, 1}, .roughness = roughness, .specular = 1, .ior = ior, .is_glass = true};
  }

  // glTF's reflectance is F0 + (F90 - F0)(1 - cos)^5. F90 of a metal is 1, so that a metal has a constant
  // reflectance only where F0 is 1, too. Of anything else F90 is the specular factor, and F0 is that factor
  // times ((ior - 1) / (ior + 1))^2, which the extension lets be 1 for the index 0: both are the same, and
  // the black below reflects nothing.
  static Surface reflecting(double share, double roughness) {
    if (share == 1) return {.base_colour = {1, 1, 1}, .metallic = 1, .roughness = roughness, .specular = 1};
    return {.roughness = roughness, .specular = share, .ior = 0};
  }

  Surface operator()(const scene::Lambert& m) const { return diffuse(m.reflectance); }
  // MaterialLimits let it through with roughness 0 only, and there it is Lambert's law.
  Surface operator()(const scene::OrenNayar& m) const { return diffuse(m.reflectance); }
  Surface operator()(const scene::Emission& m) const { return {.radiance = m.radiance}; }
  Surface operator()(const scene::Mirror& m) const { return reflecting(m.reflectance.x, 0); }
  Surface operator()(const scene::Ggx& m) const { return reflecting(m.colour.x, std::sqrt(m.alpha)); }
  Surface operator()(const scene::MetallicRoughness& m) const {
    return {.base_colour = m.reflectance, .metallic = m.metallic, .roughness = m.roughness, .specular = 1};
  }
  Surface operator()(const scene::Glass& m) const { return glass(m.ior, 0); }
  Surface operator()(const scene::RoughGlass& m) const { return glass(m.ior, std::sqrt(m.alpha)); }
};

}  // namespace

const BeyondOrbs& beyond_orbs() {
  static const BeyondOrbs kLevels{
      {"B7", "C2", "D1", "D3", "N1", "N4", "N5", "N6"},
      {{"B1", "glTF's metals are masked by the separable term"},
       {"B2", "glTF's anisotropy is an extension that readers rarely have (KHR_materials_anisotropy)"},
       {"B3", "glTF squares the roughness of each texel before it filters"},
       {"B6", "glTF has no blends of materials"},
       {"B9", "glTF's materials are metals, or dielectrics over a base"},
       {"B4",
        "glTF's dielectric takes from its base by the angle at the microfacet, and has no light inside"},
       {"B5",
        "glTF's dielectric takes from its base by the angle at the microfacet, and has no light inside"},
       {"B8", "glTF has no Phong reflection"},
       {"C1", "glTF's cameras are pinholes"},
       {"C3", "glTF's images are centred on the axis"},
       {"C4", "glTF has perspective and orthographic cameras"},
       {"D2", "the spots of glTF fall with the square of the cosine's share, not with its smoothstep"},
       {"D4", "glTF has no light with a measured intensity distribution"},
       {"D5", "the core of glTF has no environment"},
       {"D6", "the core of glTF has no environment"},
       {"E1", "glTF's metals follow Schlick's formula, not n and k"},
       {"E2", "glTF has three colours"},
       {"E3", "glTF knows no polarisation"},
       {"E4", "glTF has no fluorescence"},
       {"E5", "glTF's thin films are a fit for the eye (KHR_materials_iridescence)"},
       {"E6", "glTF's dispersion is one number of Abbe for three colours (KHR_materials_dispersion)"},
       {"N2", "glTF has normal maps and no heights"},
       {"N3", "the alpha of glTF blends or cuts what is drawn; the specification says nothing of shadows"},
       {"S7", "a plug-in is machine code for the built-in tracer"},
       {"T1", "glTF's animations turn by angles, and it has no shutter"},
       {"T2", "glTF has morph targets and no shutter"},
       {"T3", "glTF's animations turn by angles, and it has no shutter"},
       {"V1", "glTF says nothing of layers"}}};
  return kLevels;
}

std::string material_limit(const scene::Material& material) {
  return limit_of_material<SurfaceWriter>(material, kName, beyond_orbs(), MaterialLimits{material.name});
}

Surface surface_of(const scene::Material& material) {
  return written_material(material, kName, SurfaceWriter{});
}

}  // namespace orbs::adapters::gltf
