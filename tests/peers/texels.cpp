#include "peers/texels.h"

#include "image/image_io.h"
#include "peers/scenes.h"

#include <algorithm>
#include <cmath>

namespace orbs::peers {

namespace {

using scene::Wrap;

constexpr int kWidth = 5;
constexpr int kHeight = 3;

// No two texels alike; rows from the top.
double stored(int x, int y) { return std::round(255.0 * (0.1 + 0.055 * (x + kWidth * y))) / 255; }

double decoded(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::filesystem::path write_texture(bool as_float, const std::filesystem::path& folder) {
  auto image = image::make_image(kWidth, kHeight, {"R", "G", "B"});
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = static_cast<float>(stored(x, y));
  std::filesystem::create_directories(folder);
  const auto file = folder / (as_float ? "texels.exr" : "texels.png");
  if (as_float) image::write_exr(image, file, image::Precision::Float);
  if (!as_float) image::write_png(image, file);
  return file;
}

int wrapped(int texel, int count, Wrap wrap) {
  if (wrap == Wrap::Clamp) return std::clamp(texel, 0, count - 1);
  return ((texel % count) + count) % count;
}

double filtered(double u, double v, Wrap wrap_u, Wrap wrap_v, bool as_float) {
  const double x = u * kWidth - 0.5;
  const double y = v * kHeight - 0.5;
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const auto texel = [&](int i, int j) {
    const double s = stored(wrapped(i, kWidth, wrap_u), kHeight - 1 - wrapped(j, kHeight, wrap_v));
    return as_float ? s : decoded(s);
  };
  const double a = x - x0;
  const double b = y - y0;
  return (1 - b) * ((1 - a) * texel(x0, y0) + a * texel(x0 + 1, y0)) +
         b * ((1 - a) * texel(x0, y0 + 1) + a * texel(x0 + 1, y0 + 1));
}

}  // namespace

scene::Scene texture_scene(const Look& look, const std::filesystem::path& folder) {
  auto scene = empty_scene(kTexturePixels, kTexturePixels, 90);
  scene.textures.push_back({"t", write_texture(look.as_float, folder), look.wrap_u, look.wrap_v});
  const int material = add_material(scene, scene::Emission{look.tint, scene::TextureUse{0, look.matrix}});
  add_instance(scene, quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, -0.75, 1.75), material, look.place);
  scene.camera.position_m = transform_point(look.place, {0, 0, 0});
  scene.camera.look_at_m = transform_point(look.place, {0, 0, -1});
  scene.camera.up = transform_direction(look.place, {0, 1, 0});
  return scene;
}

double texture_value(const Look& look, double x_px, double y_px) {
  const double s = 2.5 * x_px / kTexturePixels - 0.75;
  const double t = 2.5 * (kTexturePixels - y_px) / kTexturePixels - 0.75;
  const double u = look.matrix(0, 0) * s + look.matrix(0, 1) * t + look.matrix(0, 3);
  const double v = look.matrix(1, 0) * s + look.matrix(1, 1) * t + look.matrix(1, 3);
  return filtered(u, v, look.wrap_u, look.wrap_v, look.as_float);
}

}  // namespace orbs::peers
