#include "adapters/gltf/textures.h"

#include "image/image_io.h"
#include "scene/lower/lower.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::adapters::gltf {

namespace {

// Of a file of 16 bits, values lie between those of 8.
bool has_eight_bits(const image::Image& image) {
  constexpr float kRounding = 1e-3F;
  return std::all_of(image.pixels.begin(), image.pixels.end(), [](float value) {
    const float step = 255 * value;
    return std::abs(step - std::round(step)) <= kRounding;
  });
}

}  // namespace

std::string texture_limit(const scene::Texture& texture, TexelsOf texels) {
  if (texels == TexelsOf::Colours && texture.encoding == scene::Encoding::Linear)
    return fmt::format("texture '{}' holds colours as plain numbers: those of glTF are sRGB", texture.name);
  if (image::is_float_format(texture.file))
    return fmt::format("texture '{}' holds floats: glTF's images have 8 bits", texture.name);
  if (has_eight_bits(image::read_image(texture.file))) return "";
  return fmt::format("texture '{}' has more than 8 bits, which glTF's images have", texture.name);
}

std::string texture_png(const scene::Texture& texture) {
  const image::Image read = image::read_image(texture.file);
  const auto channels = image::texture_channels(read);
  image::Image colours = image::make_image(read.width, read.height, {"R", "G", "B"});
  for (std::size_t i = 0; i < colours.pixels.size(); ++i)
    colours.pixels[i] = read.pixels[i / 3 * read.channel_count() + channels.at(i % 3)];
  return image::png_bytes(colours);
}

namespace {

// The uses of a material that is written, each with the place for its transform.
template <typename Material, typename Do>
void for_each_use(Material& material, TextureTransforms& transforms, const Do& visit) {
  std::visit(
      [&](auto& model) {
        if constexpr (requires { model.texture; })
          if (model.texture) visit(*model.texture, transforms.colour);
      },
      material.model);
  if (material.detail.normal_map) visit(material.detail.normal_map->texture, transforms.normals);
}

// Nothing where the extension cannot say them all.
std::optional<TextureTransforms> transforms_of(const scene::Material& material) {
  TextureTransforms transforms;
  bool can_say_all = true;
  for_each_use(material, transforms, [&](const scene::TextureUse& use, auto& transform) {
    if (use.matrix == Mat4{}) return;
    transform = texture_transform_of(use.matrix);
    can_say_all = can_say_all && transform;
  });
  return can_say_all ? std::optional(transforms) : std::nullopt;
}

}  // namespace

std::map<int, TextureTransforms> take_texture_transforms(scene::Scene& scene) {
  std::map<int, TextureTransforms> taken;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    auto transforms = transforms_of(scene.materials[i]);
    if (!transforms) continue;
    for_each_use(scene.materials[i], *transforms,
                 [](scene::TextureUse& use, const auto&) { use.matrix = {}; });
    taken[static_cast<int>(i)] = *transforms;
  }
  return taken;
}

std::string texture_matrices_limit(const scene::Scene& scene, int material) {
  return transforms_of(material_at(scene, material)) ? "" : scene::texture_matrices_problem(scene, material);
}

}  // namespace orbs::adapters::gltf
