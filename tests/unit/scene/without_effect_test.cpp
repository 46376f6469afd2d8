#include "base/error.h"
#include "scene/effects/effects.h"
#include "scene/load/load_scene.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using scene::Effect;

scene::Scene case_scene(const std::string& name) {
  return scene::load_scene(ORBS_SOURCE_DIR "/data/cases/" + name + ".json");
}

scene::Scene appearance_scene(const char* name) { return case_scene(std::string("appearance/") + name); }

bool still_calls_for(const scene::Scene& scene, Effect effect) {
  return scene::calls_for(scene::effects(scene), effect);
}

// A type of material that calls for a film and has no form without one.
struct Coated {
  static constexpr const char* kType = "coated";
};
void load(const scene::MaterialEntry&, Coated&) {}
void write(json::Writer&, const scene::SpectrumList&, const Coated&) {}
scene::MaterialRequirement requirement(const Coated&) { return {"E5", "coated"}; }
std::vector<scene::EffectVerdict> effects(const scene::SpectrumList&, const Coated&) {
  return {{Effect::ThinFilm, true, "has a film"}};
}
bool is_coloured(const scene::SpectrumList&, const Coated&) { return true; }

}  // namespace

TEST(WithoutEffect, AMaterialThatHasNoFormWithoutItIsRefusedByName) {
  Coated coated;
  EXPECT_NO_THROW(scene::leave_out_of({}, Effect::Dispersion, "lens", coated));
  try {
    scene::leave_out_of({}, Effect::ThinFilm, "lens", coated);
    FAIL() << "the film was left out";
  } catch (const InputError& e) {
    EXPECT_STREQ(
        e.what(),
        "material 'lens' has a film, and the type coated has no form without the effect 'thin film'");
  }
}

TEST(WithoutEffect, ASceneThatHasLostItCallsForItNoMore) {
  const std::vector<std::pair<const char*, Effect>> scenes{
      {"appearance/e6_dispersion/prism_SF10", Effect::Dispersion},
      {"appearance/e1_ggx_reflectance/ggx_copper_50", Effect::MeasuredMetal},
      {"appearance/e5_iridescence/iridescent_spheres_height", Effect::ThinFilm},
      {"everyday/n3_opacity/n3-mask", Effect::Opacity},
      {"everyday/n1_normal_map/n1-right", Effect::TurnedNormals},
      {"everyday/v1_layers/v1-room", Effect::SurfaceLayers},
      {"everyday/d5_environment_map/d5-studio", Effect::EnvironmentMap}};
  for (const auto& [name, effect] : scenes) {
    auto scene = case_scene(name);
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
