#include "scene/effects/switches.h"

#include "scene/load/load_scene.h"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;

namespace {

scene::Scene scene_with(const std::string& first, const std::string& second, int depth = 5) {
  const auto materials = fmt::format("{}, {}", first, second);
  const auto text = R"({"format": "orbs-scene/1", "name": "s",
    "camera": {"position": [0,0,1], "look_at": [0,0,0], "fov_y": 45, "width": 8, "height": 8},
    "integrator": {"trace_depth": )" +
                    std::to_string(depth) + R"(}, "lights": [], "materials": [)" + materials + R"(],
    "meshes": [{"name": "a", "generator": "plane", "half_size": 1, "material": "first"},
               {"name": "b", "generator": "plane", "half_size": 1, "material": "second"}],
    "instances": [{"mesh": "a"}, {"mesh": "b"}]})";
  return scene::load_scene_text("s.json", text, ".");
}

constexpr const char* kWall = R"({"name": "first", "type": "lambert", "reflectance": [0.5,0.5,0.5]})";
constexpr const char* kGlow = R"({"name": "first", "type": "emission", "radiance": [1,1,1]})";

}  // namespace

// "Only the effects" of a scene with mirrors, glass, caustics and indirect light had no answer: [].
TEST(LightSwitches, NameWhatTheSceneCallsFor) {
  const std::string mirror = R"({"name": "second", "type": "mirror", "reflectance": [0.9,0.9,0.9]})";
  EXPECT_EQ(scene::switch_words(scene_with(kWall, mirror)), "mirrors,indirect,caustics");
  EXPECT_EQ(scene::switch_words(scene_with(kWall, mirror, 1)), "mirrors");
  const std::string glass = R"({"name": "second", "type": "glass", "ior": 1.5})";
  EXPECT_EQ(scene::switch_words(scene_with(kGlow, glass)), "glass,indirect")
      << "without a surface that shows them there are no caustics";
}

TEST(LightSwitches, WhereAllEmitsNothingMatters) {
  const std::string other = R"({"name": "second", "type": "emission", "radiance": [2,1,1]})";
  const auto scene = scene_with(kGlow, other);
  EXPECT_EQ(scene::switch_words(scene), "none");
  EXPECT_EQ(scene::bounces_that_matter(scene), 0);
}
