#include "adapters/povray/materials.h"

#include "adapters/povray/sdl.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <fmt/format.h>

namespace orbs::adapters::povray {

namespace {

using scene::TextureUse;

const scene::Texture& texture_in(const scene::Scene& scene, int index) {
  return scene.textures[static_cast<std::size_t>(index)];
}

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

// Float files hold linear values and POV-Ray takes them so. `once` makes it repeat the edge texels in the
// filter; what lies beyond the edge is cut off and clamped before (clamp.h).
std::string image_map(const scene::Scene& scene,
                      const TextureUse& use,
                      const std::string& stem,
                      const char* options) {
  const scene::Texture& texture = texture_in(scene, use.texture);
  const std::string type = image_type(texture.file);
  const bool is_float = type == "exr" || type == "hdr";
  const bool once = texture.wrap_u == scene::Wrap::Clamp && texture.wrap_v == scene::Wrap::Clamp;
  return fmt::format("pigment {{ uv_mapping image_map {{ {} \"{}\"{}{} interpolate 2{} }} }}", type,
                     texture_copy(scene, use.texture, stem), is_float ? "" : " gamma srgb",
                     once ? " once" : "", options);
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

struct TextureWriter {
  const scene::Scene& scene;
  const std::string& stem;

  std::string operator()(const scene::Lambert& m) const {
    return tinted(scene, "diffuse", m.reflectance, m.texture, stem);
  }
  // povray_limits lets it through with roughness 0 only, and there it is Lambert's law.
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
  // povray_limits lets smooth ones without a film through.
  std::string operator()(const scene::Dielectric&) const { return glass({1, 1, 1}); }
  std::string operator()(const scene::Ggx& m) const { return tinted(scene, "diffuse", m.colour, {}, stem); }
  std::string operator()(const scene::RoughGlass& m) const {
    return tinted(scene, "diffuse", m.colour, {}, stem);
  }
  // povray_limits lets none through that anything shows.
  std::string operator()(const scene::AppearanceModel auto&) const {
    return tinted(scene, "diffuse", {}, {}, stem);
  }

  // What refracts, the index, is a matter of the interior.
  static std::string glass(scene::RgbColour tint) {
    return fmt::format(
        "texture {{ pigment {{ rgbf <{},{},{},1> }} finish {{ diffuse 0 reflection {{ rgb 0, {} fresnel "
        "on }} conserve_energy }} }}",
        tint.x, tint.y, tint.z, colour(tint));
  }
};

}  // namespace

Surface surface_of(const scene::MaterialModel& model) {
  if (std::holds_alternative<scene::Mirror>(model)) return Surface::Mirror;
  if (std::holds_alternative<scene::Glass>(model) || std::holds_alternative<scene::Dielectric>(model))
    return Surface::Glass;
  return Surface::Plain;
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
  return fmt::format("{}-texture{}{}", stem, index, lower_extension(texture_in(scene, index).file));
}

std::string material_declaration(const scene::Scene& scene, int material, const std::string& stem) {
  const scene::Material& m = scene.materials[static_cast<std::size_t>(material)];
  return fmt::format("#declare Material{} =\n  {}\n", material,
                     std::visit(TextureWriter{scene, stem}, m.model));
}

}  // namespace orbs::adapters::povray
