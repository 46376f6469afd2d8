#include "adapters/gltf/textures.h"

#include "image/image_io.h"

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

std::string texture_limit(const scene::Texture& texture) {
  if (texture.encoding == scene::Encoding::Linear)
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

std::map<int, TextureTransform> take_texture_transforms(scene::Scene& scene) {
  std::map<int, TextureTransform> transforms;
  const auto take = [&](int index, std::optional<scene::TextureUse>& use) {
    if (!use || use->matrix == Mat4{}) return;
    const auto transform = texture_transform_of(use->matrix);
    if (!transform) return;
    transforms[index] = *transform;
    use->matrix = {};
  };
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    std::visit(
        [&](auto& model) {
          if constexpr (requires { model.texture; }) take(static_cast<int>(i), model.texture);
        },
        scene.materials[i].model);
  return transforms;
}

}  // namespace orbs::adapters::gltf
