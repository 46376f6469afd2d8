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
