#include "tracer/colour/texture.h"

#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

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
    return tracer::apply(tracer::uv_map({.matrix = matrix}, texture), {});
  };
  EXPECT_EQ(moved(repeats, 1e9 + 0.25, -1e9 - 0.25), (Vec2f{0.25F, 0.75F}));
  EXPECT_EQ(moved(ends, 1e9, -1e9), (Vec2f{1e9F, -1e9F}));
  const scene::Texture mirrored{"", "", scene::Wrap::Mirror, scene::Wrap::Mirror};
  EXPECT_EQ(moved(mirrored, 1e9 + 0.25, -1e9 - 0.25), (Vec2f{0.25F, 1.75F})) << "two images are a period";
}

namespace {

// Four texels in a row, of which the value is the index; `wrap` is that of u.
tracer::TexelGrid row_of_four(scene::Wrap wrap, bool is_nearest) {
  tracer::TexelGrid grid{4, 1, {}, wrap, scene::Wrap::Repeat, {}};
  for (const float value : {0.0F, 1.0F, 2.0F, 3.0F}) grid.texels.push_back({value, value, value});
  grid.is_nearest = is_nearest;
  grid.is_plain = false;
  return grid;
}

}  // namespace

TEST(TracerTexture, MirroredTexelsStandTwiceAtEachEdge) {
  const auto grid = row_of_four(scene::Wrap::Mirror, true);
  const std::vector<float> expected{0, 1, 2, 3, 3, 2, 1, 0, 0, 1, 2, 3, 3, 2, 1, 0};
  for (int i = -8; i < 8; ++i)
    EXPECT_EQ(tracer::lookup(grid, {(static_cast<float>(i) + 0.5F) / 4, 0.5F}).x,
              expected[static_cast<std::size_t>(i + 8)])
        << i;
}

TEST(TracerTexture, InterpolationNearAMirroredEdgeIsFlat) {
  const auto grid = row_of_four(scene::Wrap::Mirror, false);
  const auto at = [&](float u) { return tracer::lookup(grid, {u, 0.5F}).x; };
  EXPECT_EQ(at(0), 0);
  EXPECT_EQ(at(1), 3);
  EXPECT_EQ(at(-0.0625F), 0);
  EXPECT_EQ(at(1.0625F), 3);
  EXPECT_EQ(at(0.25F), 0.5F);
  EXPECT_EQ(at(-0.25F), 0.5F);
  EXPECT_EQ(at(1.25F), 2.5F);
  EXPECT_EQ(at(2.25F), 0.5F);
}

TEST(TracerTexture, TheNearestTexelIsTheOneThatThePlaceLiesIn) {
  for (const auto& [wrap, before, beyond] :
       {std::tuple{scene::Wrap::Repeat, 3.0F, 0.0F}, std::tuple{scene::Wrap::Clamp, 0.0F, 3.0F},
        std::tuple{scene::Wrap::Mirror, 0.0F, 3.0F}}) {
    const auto grid = row_of_four(wrap, true);
    const auto at = [&](float u) { return tracer::lookup(grid, {u, 0.5F}).x; };
    EXPECT_EQ(at(0), 0);
    EXPECT_EQ(at(0.2499F), 0);
    EXPECT_EQ(at(0.25F), 1);
    EXPECT_EQ(at(0.9999F), 3);
    EXPECT_EQ(at(-0.001F), before);
    EXPECT_EQ(at(1.001F), beyond);
  }
  for (const auto wrap : {scene::Wrap::Repeat, scene::Wrap::Clamp, scene::Wrap::Mirror})
    for (const bool is_nearest : {false, true})
      for (const float far : {3e38F, -3e38F, 16777217.0F})
        EXPECT_TRUE(std::isfinite(tracer::lookup(row_of_four(wrap, is_nearest), {far, far}).x));
}
