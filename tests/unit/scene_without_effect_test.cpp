#include "scene/load_scene.h"
#include "scene/without_effect.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using scene::Effect;

scene::Scene appearance_scene(const char* name) {
  return scene::load_scene(std::string(ORBS_SOURCE_DIR "/data/cases/appearance/") + name + ".json");
}

bool still_calls_for(const scene::Scene& scene, Effect effect) {
  return scene::calls_for(scene::effects(scene), effect);
}

}  // namespace

TEST(WithoutEffect, ASceneThatHasLostItCallsForItNoMore) {
  const std::vector<std::pair<const char*, Effect>> scenes{
      {"e6_dispersion/prism_SF10", Effect::Dispersion},
      {"e1_ggx_reflectance/ggx_copper_50", Effect::MeasuredMetal},
      {"e5_iridescence/iridescent_spheres_height", Effect::ThinFilm}};
  for (const auto& [name, effect] : scenes) {
    auto scene = appearance_scene(name);
    ASSERT_TRUE(still_calls_for(scene, effect)) << name;
    EXPECT_TRUE(scene::leave_out(effect, scene)) << name;
    EXPECT_FALSE(still_calls_for(scene, effect)) << name;
  }
}

// The prism's mutant of one index is frozen at 550 nm, this one at the d line: Schott quotes 1.72825 for
// SF10.
TEST(WithoutEffect, DispersionLeavesTheIndexThatIsUsuallyQuoted) {
  auto scene = appearance_scene("e6_dispersion/prism_SF10");
  scene::leave_out(Effect::Dispersion, scene);
  const auto* glass = std::get_if<scene::Dielectric>(&scene.materials.front().model);
  ASSERT_NE(glass, nullptr);
  EXPECT_NEAR(index_at(glass->index, 400), 1.72825, 2e-5);
}

TEST(WithoutEffect, WhatTransportsCarryIsNotTheScenes) {
  const auto before = appearance_scene("e3_polarisation/polarizing_plane_0");
  auto scene = before;
  EXPECT_FALSE(scene::leave_out(Effect::Polarisation, scene));
  EXPECT_FALSE(scene::leave_out(Effect::Spectral, scene));
  EXPECT_EQ(scene, before);
}
