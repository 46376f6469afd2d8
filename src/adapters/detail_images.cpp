#include "adapters/detail_images.h"

#include "adapters/mirrored_image.h"
#include "base/error.h"
#include "image/image_io.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

// One number for each texel, made by `number` of its three channels.
template <typename Number>
void write_numbers(const scene::Texture& texture,
                   MirrorImages mirror_images,
                   const std::filesystem::path& file,
                   const Number& number) {
  with_note(fmt::format("writing the numbers of texture '{}'", texture.name), [&] {
    image::Image texels = linear_texels(texture);
    if (mirror_images == MirrorImages::Beside) texels = with_mirror_images(texels, texture);
    image::Image numbers = image::make_image(texels.width, texels.height, {"Y"});
    for (std::size_t i = 0; i < numbers.pixels.size(); ++i) numbers.pixels[i] = number(&texels.pixels[3 * i]);
    image::write_exr(numbers, file, image::Precision::Float);
  });
}

void write_normals(const scene::Texture& texture,
                   Vec2d strength,
                   MirrorImages mirror_images,
                   const std::filesystem::path& file) {
  with_note(fmt::format("writing the normals of texture '{}'", texture.name), [&] {
    image::Image texels = linear_texels(texture);
    if (mirror_images == MirrorImages::Beside) texels = with_mirror_images(texels, texture);
    const auto stretched = [](float value, double by) {
      return static_cast<float>(0.5 + by * (static_cast<double>(value) - 0.5));
    };
    for (std::size_t i = 0; i < texels.pixels.size(); i += 3) {
      texels.pixels[i] = stretched(texels.pixels[i], strength.x);
      texels.pixels[i + 1] = stretched(texels.pixels[i + 1], strength.y);
    }
    image::write_exr(texels, file, image::Precision::Float);
  });
}

}  // namespace

image::Image linear_texels(const scene::Texture& texture) {
  return image::read_linear_rgb(texture.file, texture.encoding == scene::Encoding::Linear
                                                  ? image::Encoded::Numbers
                                                  : image::Encoded::Srgb);
}

std::string opacity_image_name(int material, const std::string& stem) {
  return fmt::format("{}-opacity{}.exr", stem, material);
}

std::string height_image_name(int material, const std::string& stem) {
  return fmt::format("{}-heights{}.exr", stem, material);
}

std::string normal_image_name(int material, const std::string& stem, bool is_mirrored) {
  return fmt::format("{}-normals{}{}.exr", stem, material, is_mirrored ? "-mirrored" : "");
}

void write_detail_images(const scene::Scene& scene,
                         int material,
                         const std::filesystem::path& scene_file,
                         MirrorImages mirror_images) {
  const scene::SurfaceDetail& detail = material_at(scene, material).detail;
  const auto folder = scene_file.parent_path();
  const auto stem = scene_file.stem().string();
  if (const auto& use = detail.opacity_texture)
    write_numbers(texture_at(scene, *use), mirror_images, folder / opacity_image_name(material, stem),
                  [&](const float* rgb) {
                    return static_cast<float>(detail.opacity) * std::max({rgb[0], rgb[1], rgb[2]});
                  });
  if (const auto& map = detail.normal_map)
    for (const bool is_mirrored : {false, true})
      write_normals(texture_at(scene, map->texture),
                    {map->strength, is_mirrored ? -map->strength : map->strength}, mirror_images,
                    folder / normal_image_name(material, stem, is_mirrored));
  if (const auto& map = detail.bump_map)
    write_numbers(texture_at(scene, map->texture), mirror_images, folder / height_image_name(material, stem),
                  [&](const float* rgb) { return static_cast<float>(map->height_m) * rgb[0]; });
}

}  // namespace orbs::adapters
