#include "adapters/povray/materials.h"

#include "adapters/detail_images.h"
#include "adapters/kind_support.h"
#include "adapters/mirrored_image.h"
#include "adapters/povray/sdl.h"
#include "base/nth.h"
#include "image/image_io.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

namespace orbs::adapters::povray {

namespace {

constexpr const char* kName = "POV-Ray";

using scene::TextureUse;

const scene::Texture& texture_in(const scene::Scene& scene, int index) { return nth(scene.textures, index); }

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

// Float files hold linear values, and POV-Ray takes them as such. `once` makes it repeat the edge texels in
// the filter; coordinates beyond the edge are cut off and clamped before (clamp.h).
std::string image_map(const scene::Scene& scene,
                      const TextureUse& use,
                      const std::string& stem,
                      const char* options) {
  const scene::Texture& texture = texture_in(scene, use.texture);
  const std::string type = image_type(texture_copy(scene, use.texture, stem));
  const bool is_float = type == "exr" || type == "hdr";
  const char* gamma = is_float                                      ? ""
                      : texture.encoding == scene::Encoding::Linear ? " gamma 1.0"
                                                                    : " gamma srgb";
  const bool once = texture.wrap_u == scene::Wrap::Clamp && texture.wrap_v == scene::Wrap::Clamp;
  return fmt::format("pigment {{ uv_mapping image_map {{ {} \"{}\"{}{}{}{} }} }}", type,
                     texture_copy(scene, use.texture, stem), gamma, once ? " once" : "",
                     texture.filter == scene::Filter::Nearest ? "" : " interpolate 2", options);
}

// `part` is "diffuse" or "emission". An image that is tinted becomes two layers, since POV-Ray has no
// product of pigments: the lower one shines, the upper one is a filter of the image's colours.
std::string tinted(const scene::Scene& scene,
                   const std::string& part,
                   scene::RgbColour tint,
                   const std::optional<TextureUse>& use,
                   const std::string& stem) {
  const std::string other = part == "diffuse" ? "" : " diffuse 0";
  const std::string plain =
      fmt::format("texture {{ pigment {{ {} }} finish {{ {} 1{} }} }}", colour(tint), part, other);
  if (!use) return plain;
  if (scene::is_grey(tint))
    return fmt::format("texture {{ {} finish {{ {} {}{} }} }}", image_map(scene, *use, stem, ""), part,
                       tint.x, other);
  return fmt::format("{}\n  texture {{ {} finish {{ diffuse 0 }} }}", plain,
                     image_map(scene, *use, stem, " filter all 1"));
}

constexpr const char* kClear = "pigment { rgbt 1 } finish { diffuse 0 }";

// What stands between the braces of `texture { ... }`, as the entries of a map want it.
std::string body_of(const std::string& texture) {
  const auto open = texture.find('{');
  return texture.substr(open + 1, texture.rfind('}') - open - 1);
}

// A mean of the texture and of nothing, weighted by the opacity, which shadows follow too.
std::string with_openings(const scene::Scene& scene,
                          int material,
                          const std::string& whole,
                          const std::string& stem) {
  const scene::SurfaceDetail& detail = material_at(scene, material).detail;
  const auto& use = detail.opacity_texture;
  if (!use)
    return fmt::format("texture {{ average texture_map {{ [{} {}] [{} {}] }} }}", 1 - detail.opacity, kClear,
                       detail.opacity, body_of(whole));
  const scene::Texture& texture = texture_in(scene, use->texture);
  return fmt::format(
      "texture {{ uv_mapping image_pattern {{ exr \"{}\"{} }} texture_map {{ [0 {}] [1 {}] }} }}",
      opacity_image_name(material, stem), texture.filter == scene::Filter::Nearest ? "" : " interpolate 2",
      kClear, body_of(whole));
}

struct MaterialLimits {
  const std::string& name;

  std::string operator()(const scene::OrenNayar& m) const {
    return oren_nayar_limit(name, m.roughness, kName);
  }
  std::string operator()(const scene::Ggx&) const {
    return fmt::format(
        "material '{}' is GGX: POV-Ray has glossy highlights of light sources, no glossy reflection", name);
  }
  std::string operator()(const scene::RoughGlass&) const {
    return fmt::format("material '{}' is rough glass: POV-Ray refracts at smooth surfaces only", name);
  }
};

struct TextureWriter {
  const scene::Scene& scene;
  const std::string& stem;

  std::string operator()(const scene::Lambert& m) const {
    return tinted(scene, "diffuse", m.reflectance, m.texture, stem);
  }
  // MaterialLimits let it through with roughness 0 only, and there it is Lambert's law.
  std::string operator()(const scene::OrenNayar& m) const {
    return tinted(scene, "diffuse", m.reflectance, m.texture, stem);
  }
  std::string operator()(const scene::Emission& m) const {
    return tinted(scene, "emission", m.radiance, m.texture, stem);
  }
  std::string operator()(const scene::Mirror& m) const {
    return fmt::format("texture {{ pigment {{ rgb 0 }} finish {{ diffuse 0 reflection {{ {} }} }} }}",
                       colour(m.reflectance));
  }
  std::string operator()(const scene::Glass& m) const { return glass(m.colour); }
  // beyond_orbs lets smooth ones without a film through.
  std::string operator()(const scene::Dielectric&) const { return glass({1, 1, 1}); }

  // The index of refraction belongs to the interior of the object.
  static std::string glass(scene::RgbColour tint) {
    return fmt::format(
        "texture {{ pigment {{ rgbf <{},{},{},1> }} finish {{ diffuse 0 reflection {{ rgb 0, {} fresnel "
        "on }} conserve_energy }} }}",
        tint.x, tint.y, tint.z, colour(tint));
  }
};

// What each type does that TextureWriter writes.
struct SurfaceOf {
  Surface operator()(const scene::Lambert&) const { return Surface::Diffuse; }
  Surface operator()(const scene::OrenNayar&) const { return Surface::Diffuse; }
  Surface operator()(const scene::Emission&) const { return Surface::Emitter; }
  Surface operator()(const scene::Mirror&) const { return Surface::Mirror; }
  Surface operator()(const scene::Glass&) const { return Surface::Glass; }
  Surface operator()(const scene::Dielectric&) const { return Surface::Glass; }
};

}  // namespace

std::optional<Surface> surface_of(const scene::MaterialModel& model) {
  return std::visit(
      [](const auto& m) -> std::optional<Surface> {
        // A type that TextureWriter writes and SurfaceOf does not know is a compile error.
        if constexpr (WritesKind<TextureWriter, std::decay_t<decltype(m)>>)
          return SurfaceOf{}(m);
        else
          return std::nullopt;
      },
      model);
}

bool is_photon_target(const scene::MaterialModel& model) {
  const auto surface = surface_of(model);
  return surface == Surface::Mirror || surface == Surface::Glass;
}

std::string image_type(const std::filesystem::path& file) {
  constexpr std::array<std::pair<const char*, const char*>, 9> kTypes{{{".png", "png"},
                                                                       {".jpg", "jpeg"},
                                                                       {".jpeg", "jpeg"},
                                                                       {".tga", "tga"},
                                                                       {".tif", "tiff"},
                                                                       {".tiff", "tiff"},
                                                                       {".ppm", "ppm"},
                                                                       {".exr", "exr"},
                                                                       {".hdr", "hdr"}}};
  const std::string extension = lower_extension(file);
  for (const auto& [ending, type] : kTypes)
    if (extension == ending) return type;
  return "";
}

std::string texture_copy(const scene::Scene& scene, int index, const std::string& stem) {
  const scene::Texture& texture = texture_in(scene, index);
  const auto ending = !is_mirrored(texture)                  ? lower_extension(texture.file)
                      : image::is_float_format(texture.file) ? ".exr"
                                                             : ".png";
  return fmt::format("{}-texture{}{}", stem, index, ending);
}

const BeyondOrbs& beyond_orbs() {
  static const BeyondOrbs kLevels{
      {"C1", "C2", "C3", "C4", "D1", "D2", "D3", "D5", "D6", "E6", "N3", "N4", "N5", "N6", "S1", "S2", "S3",
       "S4"},
      {{"B1", "POV-Ray has glossy highlights of light sources, no glossy reflection"},
       {"B2", "POV-Ray has glossy highlights of light sources, no glossy reflection"},
       {"B3", "POV-Ray has glossy highlights of light sources, no glossy reflection"},
       {"B6", "the exporter writes one texture of POV-Ray for each material"},
       {"B9", "POV-Ray has glossy highlights of light sources, no glossy reflection"},
       {"B4", "POV-Ray's base under a coat lacks the Fresnel factor of the light"},
       {"B5", "POV-Ray has no glossy reflection"},
       {"B7", "POV-Ray has no microfacets"},
       {"B8", "POV-Ray's phong is a highlight of light sources alone, without the cosine"},
       {"D4", "POV-Ray's light sources have no measured intensity distribution"},
       {"E1", "POV-Ray has no indices of metals, and no glossy reflection or refraction"},
       {"E2", "POV-Ray renders in three colours"},
       {"E3", "POV-Ray carries no polarisation"},
       {"E4", "POV-Ray has no fluorescence"},
       {"E5", "POV-Ray's irid is a cosine at one wavelength for each of three colours, without any index"},
       {"N2", "POV-Ray's bumps are differences of three texels in units of its own"},
       {"S7", "a plug-in is machine code for the built-in tracer"},
       {"T1", "POV-Ray shows an instant, it has no motion blur"},
       {"T2", "POV-Ray shows an instant, it has no motion blur"},
       {"T3", "POV-Ray shows an instant, it has no motion blur"},
       {"V1", "POV-Ray renders a colour alone"}}};
  return kLevels;
}

namespace {

// Meshes have one list of texture coordinates, and layers are no part of a mean.
std::string opening_limit(const scene::Scene& scene, const scene::Material& material) {
  const auto& use = material.detail.opacity_texture;
  const auto& own = texture_of(material.model);
  if (!lets_rays_pass(material.detail) || !own) return "";
  if (!std::holds_alternative<scene::Lambert>(material.model) ||
      !scene::is_grey(std::get<scene::Lambert>(material.model).reflectance))
    return fmt::format("material '{}' has a tinted texture and lets rays pass: POV-Ray mixes no layers",
                       material.name);
  if (!use) return "";
  const scene::Texture& a = texture_at(scene, *own);
  const scene::Texture& b = texture_at(scene, *use);
  if (own->matrix == use->matrix && own->uv_set == use->uv_set && a.wrap_u == b.wrap_u &&
      a.wrap_v == b.wrap_v)
    return "";
  return fmt::format("material '{}' has textures that lie differently: POV-Ray has one list of coordinates",
                     material.name);
}

}  // namespace

std::string material_limit(const scene::Scene& scene, const scene::Material& material) {
  if (auto reason = opening_limit(scene, material); !reason.empty()) return reason;
  return limit_of_material<TextureWriter>(material, kName, beyond_orbs(), MaterialLimits{material.name});
}

std::string material_declaration(const scene::Scene& scene, int material, const std::string& stem) {
  const auto& m = material_at(scene, material);
  const auto whole = text_of_material(m, kName, TextureWriter{scene, stem});
  return fmt::format("#declare Material{} =\n  {}\n", material,
                     lets_rays_pass(m.detail) ? with_openings(scene, material, whole, stem) : whole);
}

}  // namespace orbs::adapters::povray
