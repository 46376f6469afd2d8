#include "adapters/tinted_image.h"

#include "base/error.h"
#include "image/image_io.h"
#include "image/linear_rgb.h"

#include <array>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

struct Colour {
  scene::RgbColour operator()(const scene::Lambert& m) const { return m.reflectance; }
  scene::RgbColour operator()(const scene::OrenNayar& m) const { return m.reflectance; }
  scene::RgbColour operator()(const scene::Mirror& m) const { return m.reflectance; }
  scene::RgbColour operator()(const scene::Glass& m) const { return m.colour; }
  scene::RgbColour operator()(const scene::Ggx& m) const { return m.colour; }
  scene::RgbColour operator()(const scene::RoughGlass& m) const { return m.colour; }
  scene::RgbColour operator()(const scene::Emission& m) const { return m.radiance; }
  // None of them has a texture.
  scene::RgbColour operator()(const scene::AppearanceModel auto&) const { return {}; }
};

}  // namespace

std::string tinted_image_name(int material, const std::string& stem) {
  return fmt::format("{}-material{}.exr", stem, material);
}

void write_tinted(const scene::Scene& scene, int material, const std::filesystem::path& file) {
  const scene::MaterialModel& model = scene.materials[static_cast<std::size_t>(material)].model;
  const scene::RgbColour tint = std::visit(Colour{}, model);
  const auto& texture = scene.textures[static_cast<std::size_t>(scene::texture_of(model)->texture)];
  with_note(fmt::format("tinting texture '{}'", texture.name), [&] {
    image::Image image = image::read_linear_rgb(texture.file);
    const std::array factors{tint.x, tint.y, tint.z};
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      image.pixels[i] = static_cast<float>(static_cast<double>(image.pixels[i]) * factors[i % 3]);
    image::write_exr(image, file);
  });
}

}  // namespace orbs::adapters
