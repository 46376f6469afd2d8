// Who gives way where a glossy and a diffuse reflectance exceed 1 together.
#include "scene/materials/ggx_lambert.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs::scene;

void expect_mixed(Mix mix, orbs::Vec3d glossy, orbs::Vec3d diffuse) {
  const auto mixed = mixed_colours({{0.6, 0.4, 0.2}, 0.1, {0.3, 0.7, 0.5}, mix});
  for (const auto& [found, expected] : {std::pair{mixed.glossy, glossy}, std::pair{mixed.diffuse, diffuse}}) {
    EXPECT_NEAR(found.x, expected.x, 1e-12);
    EXPECT_NEAR(found.y, expected.y, 1e-12);
    EXPECT_NEAR(found.z, expected.z, 1e-12);
  }
}

}  // namespace

TEST(GgxLambert, ColoursGiveWayByTheRule) {
  const orbs::Vec3d glossy{0.6, 0.4, 0.2};
  expect_mixed(Mix::Maximum, glossy, {0.3 * 4 / 7, 0.4, 0.5 * 4 / 7});
  expect_mixed(Mix::Average, glossy, {0.3 * 6 / 7, 0.6, 0.5 * 6 / 7});
  expect_mixed(Mix::PerComponent, glossy, {0.3, 0.6, 0.5});
  expect_mixed(Mix::Sum, {0.6, 0.4 / 1.1, 0.2}, {0.3, 0.7 / 1.1, 0.5});
}

TEST(GgxLambert, NothingGivesWayBelowOne) {
  const GgxLambert m{{0.3, 0.2, 0.1}, 0.1, {0.4, 0.5, 0.6}, Mix::Maximum};
  EXPECT_EQ(mixed_colours(m).diffuse, m.diffuse);
  const auto mean = mix_as_mean(m);
  EXPECT_NEAR(mean.glossy.x * (1 - mean.weight), 0.3, 1e-12);
  EXPECT_NEAR(mean.diffuse.z * mean.weight, 0.6, 1e-12);
}
