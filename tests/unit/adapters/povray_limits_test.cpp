#include "adapters/povray/povray.h"
#include "scene/geometry/generators.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace orbs;

scene::Scene scene_with(const scene::MaterialModel& model) {
  scene::Scene scene;
  scene.materials.push_back({"stuff", model});
  scene.meshes.push_back(scene::make_plane({1}));
  scene.meshes[0].triangle_materials.assign(2, 0);
  scene.instances.push_back({"i", 0, {}, {}});
  return scene;
}

bool one_reason_with(const scene::Scene& scene, const std::string& word) {
  const auto reasons = adapters::povray_limits(scene);
  return reasons.size() == 1 && reasons[0].find(word) != std::string::npos;
}

TEST(PovrayLimits, PlainSceneHasNone) {
  auto scene = scene_with(scene::Lambert{{0.5, 0.5, 0.5}, {}});
  scene.lights.push_back({"l", scene::RectShape{1, 2}, {1, 1, 1}, rotation_x(30) * scaling({1, 2, 3}), {}});
  scene.lights.push_back({"s", scene::SphereShape{1}, {1, 1, 1}, rotation_x(30) * scaling({2, 2, 2}), {}});
  EXPECT_TRUE(adapters::povray_limits(scene).empty());
}

TEST(PovrayLimits, OfInterfacesByTheirIndicesPovrayHasSmoothGlassAlone) {
  const scene::Dielectric prism{spectra::Cauchy{1.7, 0.01, 0, 0}, spectra::constant(1), {}, {}};
  EXPECT_TRUE(adapters::povray_limits(scene_with(prism)).empty());
  auto rough = prism;
  rough.roughness = scene::Roughness{};
  EXPECT_TRUE(one_reason_with(scene_with(rough), "no glossy reflection or refraction"));
  const scene::Conductor metal{
      {spectra::constant(1.9), spectra::constant(1.5)}, spectra::constant(1), {}, {}};
  EXPECT_TRUE(one_reason_with(scene_with(metal), "no indices of metals"));
  auto film = metal;
  film.film = scene::Film{spectra::constant(1.33), 550};
  const auto reasons = adapters::povray_limits(scene_with(film));
  EXPECT_EQ(
      std::count_if(reasons.begin(), reasons.end(),
                    [](const auto& reason) { return reason.find("irid is a cosine") != std::string::npos; }),
      1);
}

TEST(PovrayLimits, NamesMaterialsThatPovrayLacks) {
  EXPECT_TRUE(one_reason_with(scene_with(scene::Ggx{{1, 1, 1}, 0.1}), "'stuff' is GGX"));
  EXPECT_TRUE(one_reason_with(scene_with(scene::RoughGlass{{1, 1, 1}, 1.5, 0.1}), "rough glass"));
  EXPECT_TRUE(one_reason_with(scene_with(scene::OrenNayar{{1, 1, 1}, 0.5, {}}), "Oren-Nayar"));
  EXPECT_TRUE(adapters::povray_limits(scene_with(scene::OrenNayar{{1, 1, 1}, 0, {}})).empty());
}

// Oren-Nayar of roughness 0 is Lambert, and lit through glass like it.
TEST(PovrayLimits, LightThroughGlassOnWhatIsDiffuseTakesPhotons) {
  for (const scene::MaterialModel& floor : {scene::MaterialModel{scene::Lambert{{0.5, 0.5, 0.5}, {}}},
                                            scene::MaterialModel{scene::OrenNayar{}}}) {
    auto scene = scene_with(floor);
    scene.trace_depth = 4;
    scene.lights.push_back({"l", scene::SphereShape{1}, {1, 1, 1}, {}, {}});
    EXPECT_TRUE(adapters::povray_limits(scene).empty());
    scene.materials.push_back({"glass", scene::Glass{}});
    scene.instances.push_back({"lens", 0, {}, {}});
    scene.meshes[0].triangle_materials[1] = 1;
    EXPECT_TRUE(one_reason_with(scene, "takes photons"));
  }
}

TEST(PovrayLimits, LooksOnlyAtWhatIsShown) {
  auto scene = scene_with(scene::Ggx{{1, 1, 1}, 0.1});
  scene.materials.push_back({"plain", scene::Lambert{{1, 1, 1}, {}}});
  scene.instances[0].remap = {{0, 1}};
  EXPECT_TRUE(adapters::povray_limits(scene).empty());
  scene.instances.clear();
  EXPECT_TRUE(adapters::povray_limits(scene).empty());
}

TEST(PovrayLimits, NamesLightsThatPovrayLacks) {
  auto scene = scene_with(scene::Lambert{{0.5, 0.5, 0.5}, {}});
  scene.lights.push_back({"egg", scene::SphereShape{1}, {1, 1, 1}, scaling({1, 1, 1.1}), {}});
  EXPECT_TRUE(one_reason_with(scene, "'egg'"));
  scene.lights[0] = {"lamp", scene::RectShape{1, 1}, {1, 1, 1}, {}, scene::IesUse{}};
  EXPECT_TRUE(one_reason_with(scene, "IES"));
}

TEST(PovrayLimits, NamesImagesThatPovrayCannotReadOrClamp) {
  auto scene = scene_with(scene::Lambert{{1, 1, 1}, scene::TextureUse{0, {}}});
  scene.textures.push_back({"t", "/a/b.webp", scene::Wrap::Repeat, scene::Wrap::Repeat});
  EXPECT_TRUE(one_reason_with(scene, ".webp"));
  scene.textures[0] = {"t", "/a/b.jpg", scene::Wrap::Clamp, scene::Wrap::Repeat};
  EXPECT_TRUE(one_reason_with(scene, "one axis"));
  scene.textures[0].file = "/a/b.png";
  EXPECT_TRUE(adapters::povray_limits(scene).empty());
}

// 2^n x 2^n cells of a pixel for spp = 4^n.
TEST(PovrayLimits, AntialiasingDepthFollowsTheSamples) {
  EXPECT_EQ(adapters::povray_aa_grid(1), 4);  // fewer would soften and move edges
  EXPECT_EQ(adapters::povray_aa_grid(128), 4);
  EXPECT_EQ(adapters::povray_aa_grid(256), 4);
  EXPECT_EQ(adapters::povray_aa_grid(257), 5);
  EXPECT_EQ(adapters::povray_aa_grid(1 << 30), 9);
}

}  // namespace
