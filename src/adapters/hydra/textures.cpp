#include "adapters/hydra/textures.h"

#include "adapters/hydra/binary.h"
#include "adapters/mirrored_image.h"
#include "adapters/xml_comment.h"
#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::adapters::hydra {

namespace {

struct TextureFile {
  std::string bytes;
  int width_px = 0;
  int height_px = 0;
  bool is_linear = false;
};

// Values of 16 bits between two bytes are a 257th of a step from either at least.
bool holds_bytes(const image::Image& image) {
  return std::all_of(image.pixels.begin(), image.pixels.end(), [](float value) {
    constexpr float kRounding = 1e-3F;
    return std::abs(value * 255 - std::round(value * 255)) < kRounding;
  });
}

// Width and height, then rows of RGBA from the bottom.
template <typename Append>
std::string image_bytes(const image::Image& image,
                        const std::array<std::size_t, 3>& channels,
                        Append append_texel) {
  std::string bytes;
  append_bytes(bytes, std::int32_t{image.width});
  append_bytes(bytes, std::int32_t{image.height});
  for (int y = image.height - 1; y >= 0; --y)
    for (int x = 0; x < image.width; ++x) {
      for (const auto c : channels) append_texel(bytes, image.at(x, y, c));
      append_texel(bytes, 1.0F);
    }
  return bytes;
}

TextureFile linear_file(const image::Image& linear) {
  return {image_bytes(linear, {0, 1, 2}, [](std::string& bytes, float value) { append_bytes(bytes, value); }),
          linear.width, linear.height, true};
}

// Eight-bit images keep their bytes, which HydraCore3 decodes by the sRGB curve itself; others become linear
// floats, as it has no format for 16 bits. It reads the word for mirrored images and lets them repeat.
TextureFile texture_file(const scene::Texture& texture) {
  const auto& file = texture.file;
  const bool is_data = texture.encoding == scene::Encoding::Linear;
  if (!is_data && !image::is_float_format(file)) {
    const image::Image stored = with_mirror_images(image::read_image(file), texture);
    if (holds_bytes(stored))
      return {image_bytes(stored, image::texture_channels(stored),
                          [](std::string& bytes, float value) {
                            bytes += static_cast<char>(static_cast<unsigned char>(std::lround(value * 255)));
                          }),
              stored.width, stored.height, false};
  }
  return linear_file(with_mirror_images(
      image::read_linear_rgb(file, is_data ? image::Encoded::Numbers : image::Encoded::Srgb), texture));
}

// It skips an entry without its sizes, and takes the size of a texel from them.
int add_file(TextureLibrary& library,
             const TextureFile& texture,
             const std::filesystem::path& folder,
             const std::string& name) {
  constexpr std::size_t kHeader_bytes = 8;
  const auto file = fmt::format("{}.{}", name, texture.is_linear ? "image4f" : "image4ub");
  write_file(folder / file, texture.bytes);
  library.text += fmt::format("<texture id=\"{}\" loc=\"{}\" width=\"{}\" height=\"{}\" bytesize=\"{}\"/>\n",
                              library.count, file, texture.width_px, texture.height_px,
                              texture.bytes.size() - kHeader_bytes);
  return library.count++;
}

const char* wrap_word(scene::Wrap wrap) { return wrap == scene::Wrap::Clamp ? "clamp" : "wrap"; }

}  // namespace

TextureLibrary write_textures(const scene::Scene& scene,
                              const std::filesystem::path& folder,
                              const std::string& stem) {
  TextureLibrary library;
  for (const int material : scene::visible_materials(scene)) {
    const auto& use = scene::texture_of(material_at(scene, material).model);
    if (!use || library.entries.contains(use->texture)) continue;
    const scene::Texture& texture = texture_at(scene, *use);
    with_note(fmt::format("writing texture '{}' for HydraCore3", texture.name), [&] {
      const TextureFile written = texture_file(texture);
      library.text += xml_comment(texture.name);
      const int id = add_file(library, written, folder, fmt::format("{}-texture{}", stem, library.count));
      library.entries.emplace(use->texture, TextureEntry{id, written.is_linear});
    });
  }
  return library;
}

int add_image(TextureLibrary& library,
              const image::Image& image,
              const std::filesystem::path& folder,
              const std::string& name) {
  return add_file(library, linear_file(image), folder, name);
}

std::string texture_node(const scene::Scene& scene,
                         const TextureLibrary& library,
                         const scene::TextureUse& use) {
  const scene::Texture& texture = texture_at(scene, use);
  const TextureEntry& entry = library.entries.at(use.texture);
  const Vec2d scale = unmirrored_uv_scale(texture);
  const Mat4 matrix = scaling({scale.x, scale.y, 1}) * use.matrix;
  return fmt::format(
      "<texture id=\"{}\" type=\"texref\" matrix=\"{}\" addressing_mode_u=\"{}\" addressing_mode_v=\"{}\" "
      "input_gamma=\"{}\"/>",
      entry.id, fmt::join(matrix.m, " "), wrap_word(texture.wrap_u), wrap_word(texture.wrap_v),
      entry.is_linear ? "1" : "2.2");
}

}  // namespace orbs::adapters::hydra
