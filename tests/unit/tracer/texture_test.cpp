#include "tracer/colour/texture.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

using namespace orbs;

// A scene may scale texture coordinates by 1e12 and more, and a texel is found by a cast to int.
TEST(TracerTexture, CoordinatesThatAreNoNumberHaveNoTexel) {
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  for (const auto wrap : {scene::Wrap::Repeat, scene::Wrap::Clamp}) {
    const tracer::TexelGrid grid{2, 1, {Vec3f{1, 1, 1}, Vec3f{1, 1, 1}}, wrap, wrap, {}};
    for (const Vec2f uv : {Vec2f{kInfinite, 0}, Vec2f{0, -kInfinite}, Vec2f{std::nanf(""), 0}})
      EXPECT_TRUE(std::isnan(tracer::lookup(grid, uv).x));
    for (const float far : {3e38F, -3e38F}) EXPECT_EQ(tracer::lookup(grid, {far, far}).x, 1);
  }
}

// Floats of 10^9 are 64 apart.
TEST(TracerTexture, WholePeriodsOfAMatrixLeaveTheFraction) {
  const scene::Texture repeats{"", "", scene::Wrap::Repeat, scene::Wrap::Repeat};
  const scene::Texture ends{"", "", scene::Wrap::Clamp, scene::Wrap::Clamp};
  const auto moved = [](const scene::Texture& texture, double u, double v) {
    Mat4 matrix;
    matrix(0, 3) = u;
    matrix(1, 3) = v;
    return tracer::apply(tracer::uv_map(matrix, texture), {});
  };
  EXPECT_EQ(moved(repeats, 1e9 + 0.25, -1e9 - 0.25), (Vec2f{0.25F, 0.75F}));
  EXPECT_EQ(moved(ends, 1e9, -1e9), (Vec2f{1e9F, -1e9F}));
}
