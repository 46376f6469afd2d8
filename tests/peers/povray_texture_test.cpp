#include "peers/povray_render.h"
#include "peers/texels.h"

#include <array>

#include <gtest/gtest.h>

/// Where POV-Ray finds a texel and how it filters, at the centre of every pixel.
namespace {

using namespace orbs;
using namespace orbs::peers;
using scene::Wrap;

void expect_texture(const Look& look) {
  const auto scene = texture_scene(look, std::filesystem::path(ORBS_BINARY_DIR) / "povray-tests");
  const auto image = render_with_povray(scene, look.name);
  const std::array tint{look.tint.x, look.tint.y, look.tint.z};
  for (int y = 0; y < kTexturePixels; ++y)
    for (int x = 0; x < kTexturePixels; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        ASSERT_NEAR(static_cast<double>(image.at(x, y, c)),
                    tint.at(c) * texture_value(look, x + 0.5, y + 0.5), 1.5e-3 * tint.at(c))
            << look.name << " " << x << " " << y;
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

TEST(PovrayTexture, TintsTheImageWithAnyColour) {
  expect_texture({.name = "grey", .tint = {0.5, 0.5, 0.5}});
  expect_texture({.name = "tint", .tint = {3, 0.5, 0}});
}

TEST(PovrayTexture, MovesWithTheInstance) {
  expect_texture({.name = "moved",
                  .place = translation({3, -2, 5}) * rotation_y(40) * rotation_x(25) * scaling({2, 2, 2})});
}

}  // namespace
