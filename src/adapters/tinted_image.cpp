#include "adapters/tinted_image.h"

#include "adapters/detail_images.h"
#include "adapters/mirrored_image.h"
#include "base/error.h"
#include "image/image_io.h"

#include <array>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

// The colour that a material's texture is multiplied by, or the number: the weight of a blend, a roughness.
scene::RgbColour tint_of(const scene::MaterialModel& model) {
  return std::visit(
      [](const auto& m) -> scene::RgbColour {
        if constexpr (!requires { m.texture; })
          return {};
        else if constexpr (requires { m.radiance; })
          return m.radiance;
        else if constexpr (requires { m.reflectance; })
          return m.reflectance;
        else if constexpr (requires { m.weight; })
          return {m.weight, m.weight, m.weight};
        else
          return {m.alpha, m.alpha, m.alpha};
      },
      model);
}

image::Image tinted(const scene::Scene& scene, int material) {
  const scene::MaterialModel& model = material_at(scene, material).model;
  const scene::RgbColour tint = tint_of(model);
  const std::array factors{tint.x, tint.y, tint.z};
  const scene::Texture& texture = texture_at(scene, *texture_of(model));
  image::Image image = linear_texels(texture);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<float>(static_cast<double>(image.pixels[i]) * factors[i % 3]);
  const auto* rough = std::get_if<scene::VaryingGgx>(&model);
  if (rough != nullptr && rough->is_glossiness)
    for (float& value : image.pixels) value = 1 - value;
  return image;
}

template <typename Action>
void with_texture_note(const scene::Scene& scene, int material, const Action& action) {
  const auto& use = *texture_of(material_at(scene, material).model);
  with_note(fmt::format("tinting texture '{}'", texture_at(scene, use).name), action);
}

}  // namespace

std::string tinted_image_name(int material, const std::string& stem) {
  return fmt::format("{}-material{}.exr", stem, material);
}

std::array<std::string, 3> tinted_channel_names(int material, const std::string& stem) {
  const auto name = [&](char channel) {
    return fmt::format("{}-material{}-{}.exr", stem, material, channel);
  };
  return {name('r'), name('g'), name('b')};
}

void write_tinted(const scene::Scene& scene, int material, const std::filesystem::path& file) {
  with_texture_note(scene, material, [&] { image::write_exr(tinted(scene, material), file); });
}

void write_tinted_channels(const scene::Scene& scene,
                           int material,
                           const std::filesystem::path& folder,
                           const std::string& stem) {
  with_texture_note(scene, material, [&] {
    const image::Image image = with_mirror_images(
        tinted(scene, material), texture_at(scene, *texture_of(material_at(scene, material).model)));
    const auto names = tinted_channel_names(material, stem);
    for (std::size_t c = 0; c < names.size(); ++c) {
      image::Image channel = image::make_image(image.width, image.height, {"Y"});
      for (std::size_t i = 0; i < channel.pixels.size(); ++i) channel.pixels[i] = image.pixels[3 * i + c];
      image::write_exr(channel, folder / names[c]);
    }
  });
}

}  // namespace orbs::adapters
