#include "peers/povray_scenes.h"

#include <array>
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

/// Where POV-Ray finds a texel and how it filters, against the definition: sRGB decoded per texel, then
/// bilinear between texel centres at +0.5, v = 0 at the bottom row, each axis repeated or clamped.
namespace {

using namespace orbs;
using namespace orbs::peers;
using scene::Wrap;

constexpr int kWidth = 5;
constexpr int kHeight = 3;
constexpr int kSize = 48;

// No two texels alike; rows from the top.
double stored(int x, int y) { return std::round(255.0 * (0.1 + 0.055 * (x + kWidth * y))) / 255; }

double decoded(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::filesystem::path write_texture(bool as_float) {
  auto image = image::make_image(kWidth, kHeight, {"R", "G", "B"});
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = static_cast<float>(stored(x, y));
  const auto folder = std::filesystem::path(ORBS_BINARY_DIR) / "povray-tests";
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

struct Look {
  const char* name;
  Wrap wrap_u = Wrap::Repeat;
  Wrap wrap_v = Wrap::Repeat;
  Mat4 matrix{};
  bool as_float = false;
  scene::Rgb tint{1, 1, 1};
  Mat4 place{};  // of the instance, which must not move the picture on the surface
};

// A quad that fills the picture, coordinates from -0.75 to 1.75 along both sides.
void expect_texture(const Look& look) {
  auto scene = empty_scene(kSize, kSize, 90);
  scene.textures.push_back({"t", write_texture(look.as_float), look.wrap_u, look.wrap_v});
  const int material = add_material(scene, scene::Emission{look.tint, scene::TextureUse{0, look.matrix}});
  add_instance(scene, quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, -0.75, 1.75), material);
  scene.instances[0].matrix = look.place;
  const Mat4& place = look.place;
  scene.camera.position_m = transform_point(place, {0, 0, 0});
  scene.camera.look_at_m = transform_point(place, {0, 0, -1});
  scene.camera.up = transform_direction(place, {0, 1, 0});
  const auto image = render_with_povray(scene, look.name);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const double s = 2.5 * (x + 0.5) / kSize - 0.75;
      const double t = 2.5 * (kSize - y - 0.5) / kSize - 0.75;
      const double u = look.matrix(0, 0) * s + look.matrix(0, 1) * t + look.matrix(0, 3);
      const double v = look.matrix(1, 0) * s + look.matrix(1, 1) * t + look.matrix(1, 3);
      const double expected = filtered(u, v, look.wrap_u, look.wrap_v, look.as_float);
      const std::array tint{look.tint.x, look.tint.y, look.tint.z};
      for (std::size_t c = 0; c < 3; ++c)
        ASSERT_NEAR(static_cast<double>(image.at(x, y, c)), tint[c] * expected, 1.5e-3 * tint[c])
            << look.name << " " << x << " " << y;
    }
}

TEST(PovrayTexture, RepeatsAndFiltersInLinearLight) { expect_texture({.name = "repeat"}); }

TEST(PovrayTexture, TakesFloatFilesAsLinear) { expect_texture({.name = "float", .as_float = true}); }

TEST(PovrayTexture, ClampsBothAxes) {
  expect_texture({.name = "clamp", .wrap_u = Wrap::Clamp, .wrap_v = Wrap::Clamp});
}

TEST(PovrayTexture, ClampsOneAxisAndRepeatsTheOther) {
  expect_texture({.name = "clamp-u", .wrap_u = Wrap::Clamp});
  expect_texture({.name = "clamp-v", .wrap_v = Wrap::Clamp});
}

TEST(PovrayTexture, AppliesTheTextureMatrix) {
  Mat4 matrix{};
  matrix.m = {0.8, -0.3, 0, 0.5, 0.2, 0.6, 0, -0.7, 0, 0, 1, 0, 0, 0, 0, 1};
  expect_texture({.name = "matrix", .matrix = matrix});
  expect_texture({.name = "matrix-clamp", .wrap_u = Wrap::Clamp, .wrap_v = Wrap::Clamp, .matrix = matrix});
}

TEST(PovrayTexture, TintsThePictureWithAnyColour) {
  expect_texture({.name = "grey", .tint = {0.5, 0.5, 0.5}});
  expect_texture({.name = "tint", .tint = {3, 0.5, 0}});
}

TEST(PovrayTexture, MovesWithTheInstance) {
  expect_texture({.name = "moved",
                  .place = translation({3, -2, 5}) * rotation_y(40) * rotation_x(25) * scaling({2, 2, 2})});
}

}  // namespace
