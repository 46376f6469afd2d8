#include "scene/mirrored_frames.h"

#include "scene/load/load_scene.h"

#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using scene::FrameSign;

// Four cards with one normal map: "plain", "u mirrored", "turned", and "mirrored" by its matrix.
scene::Scene cards() {
  return scene::load_scene(std::filesystem::path(ORBS_SOURCE_DIR) /
                           "data/cases/everyday/n1_normal_map/n1-above.json");
}

std::set<std::string> instances_in(const scene::Scene& scene, int material) {
  std::set<std::string> names;
  for (const auto& instance : scene.instances)
    for (const int one : mesh_of(scene, instance).triangle_materials)
      if (one == material) names.insert(instance.name);
  return names;
}

TEST(MirroredFrames, WrongOnesGetAMaterialOfTheirOwn) {
  for (const auto& [known, wrong] :
       {std::pair{FrameSign::None, std::set<std::string>{"u mirrored", "mirrored"}},
        std::pair{FrameSign::OfMesh, std::set<std::string>{"mirrored"}}}) {
    const auto split = scene::with_materials_by_frames(cards(), known);
    ASSERT_EQ(split.materials.size(), 2U);
    EXPECT_EQ(instances_in(split, 1), wrong);
    EXPECT_EQ(scene::materials_in_wrong_frames(split, known), std::set{1});
    EXPECT_EQ(split.materials[1].detail, split.materials[0].detail);
  }
}

// What mirrors twice mirrors nothing.
TEST(MirroredFrames, AMeshMayStandInBoth) {
  auto scene = cards();
  scene.instances = {
      {"plain", 0, {}, {}}, {"mirrored", 0, scaling({-1, 1, 1}), {}}, {"twice", 1, scaling({1, -1, 1}), {}}};
  const auto split = scene::with_materials_by_frames(scene, FrameSign::None);
  EXPECT_EQ(instances_in(split, 1), std::set<std::string>{"mirrored"});
  EXPECT_EQ(instances_in(split, 0), (std::set<std::string>{"plain", "twice"}));
}

TEST(MirroredFrames, WithoutNormalMapsThereAreNone) {
  auto scene = cards();
  scene.materials[0].detail = {};
  EXPECT_TRUE(scene::materials_in_wrong_frames(scene, FrameSign::None).empty());
  EXPECT_EQ(scene::with_materials_by_frames(scene, FrameSign::None).materials.size(), 1U);
}

}  // namespace
