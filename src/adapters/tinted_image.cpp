#include "adapters/tinted_image.h"

#include "base/error.h"
#include "image/image_io.h"
#include "image/linear_rgb.h"

#include <array>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

// The colour that a material's texture is multiplied by.
scene::RgbColour tint_of(const scene::MaterialModel& model) {
  return std::visit(
      [](const auto& m) -> scene::RgbColour {
        if constexpr (!requires { m.texture; })
          return {};
        else if constexpr (requires { m.radiance; })
          return m.radiance;
        else
          return m.reflectance;
      },
      model);
}

}  // namespace

std::string tinted_image_name(int material, const std::string& stem) {
  return fmt::format("{}-material{}.exr", stem, material);
}

void write_tinted(const scene::Scene& scene, int material, const std::filesystem::path& file) {
  const scene::MaterialModel& model = material_at(scene, material).model;
  const scene::RgbColour tint = tint_of(model);
  const auto& texture = texture_at(scene, *texture_of(model));
  with_note(fmt::format("tinting texture '{}'", texture.name), [&] {
    image::Image image = image::read_linear_rgb(texture.file);
    const std::array factors{tint.x, tint.y, tint.z};
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      image.pixels[i] = static_cast<float>(static_cast<double>(image.pixels[i]) * factors[i % 3]);
    image::write_exr(image, file);
  });
}

}  // namespace orbs::adapters
