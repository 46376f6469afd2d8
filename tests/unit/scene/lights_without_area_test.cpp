#include "base/error.h"
#include "scene/effects/effects.h"
#include "scene/effects/features.h"
#include "scene/geometry/world_bounds.h"
#include "scene/load/load_scene.h"
#include "scene/lower/lower.h"
#include "scene/relations/light.h"
#include "scene/relations/motion.h"
#include "scene/render_fault.h"
#include "scene/seen_at.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::scene;

Scene scene_with(const std::string& lights) {
  return load_scene_text(
      "test.json",
      R"({"format": "orbs-scene/1", "name": "test", "camera": {"position": [0, 0, 5], "look_at": )"
      R"([0, 0, 0]}, "materials": [], "meshes": [], "instances": [], "lights": [)" +
          lights + "]}",
      ORBS_SOURCE_DIR "/data/cases/known/l4_ies");
}

std::string refusal_of(const std::string& light) {
  try {
    scene_with(light);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string kPoint =
    R"({"name": "p", "type": "point", "intensity": [3, 2, 1], "matrix": [{"scale": 2}]})";
const std::string kSpot =
    R"({"name": "s", "type": "spot", "intensity": [1, 1, 1], "inner": 10, "outer": 20})";
const std::string kSun = R"({"name": "d", "type": "directional", "irradiance": [1, 1, 1]})";
const std::string kAll = kPoint + "," + kSpot + "," + kSun;

TEST(LightsWithoutArea, AreReadAndWrittenByTheirOwnWords) {
  const auto scene = scene_with(kAll);
  EXPECT_EQ(scene.lights[0].radiance, (RgbColour{3, 2, 1}));
  EXPECT_EQ(std::get<SpotShape>(scene.lights[1].shape), (SpotShape{10, 20}));
  json::Writer out;
  out.begin_array();
  for (const auto& light : scene.lights) write_light(out, scene.spectra, light);
  const std::string text = out.end_array().text();
  const auto again = scene_with(text.substr(text.find('[') + 1, text.rfind(']') - text.find('[') - 1));
  EXPECT_EQ(again.lights, scene.lights);
  EXPECT_NE(text.find("intensity"), std::string::npos);
  EXPECT_NE(text.find("irradiance"), std::string::npos);
}

TEST(LightsWithoutArea, RefuseWhatTheyDoNotHave) {
  EXPECT_NE(refusal_of(R"({"type": "point", "radiance": [1, 1, 1]})").find("intensity"), std::string::npos);
  EXPECT_NE(refusal_of(R"({"type": "point", "intensity": [1, 1, 1], "reflectance": [1, 1, 1]})")
                .find("reflectance"),
            std::string::npos);
  EXPECT_NE(
      refusal_of(R"({"type": "spot", "intensity": [1, 1, 1], "inner": 30, "outer": 20})").find("half angles"),
      std::string::npos);
  EXPECT_NE(
      refusal_of(R"({"type": "spot", "intensity": [1, 1, 1], "inner": 30, "outer": 200})").find("outer"),
      std::string::npos);
  for (const char* kind : {R"("spot", "intensity": [1, 1, 1], "inner": 1, "outer": 2)",
                           R"("directional", "irradiance": [1, 1, 1])"})
    EXPECT_NE(refusal_of(std::string(R"({"type": )") + kind + R"(, "ies": {"file": "cosine_squared.ies"}})")
                  .find("ies"),
              std::string::npos)
        << kind;
  EXPECT_EQ(refusal_of(R"({"type": "point", "intensity": [1, 1, 1], "ies": {"file": "cosine_squared.ies"}})"),
            "");
}

TEST(LightsWithoutArea, HaveRequirementsAndAnEffectOfTheirOwn) {
  const auto codes = [](const std::string& lights) {
    std::string all;
    for (const auto& feature : features_of_lights(scene_with(lights))) all += feature.requirement + " ";
    return all;
  };
  EXPECT_EQ(codes(kAll), "D1 D2 D3 ");
  EXPECT_EQ(codes(R"({"type": "point", "intensity": [1, 1, 1], "ies": {"file": "cosine_squared.ies"}})"),
            "D1 D4 ");
  EXPECT_TRUE(calls_for(effects(scene_with(kSun)), Effect::LightWithoutArea));
}

// Their levels have them wherever they stand, so that L3 is not asked for.
TEST(LightsWithoutArea, AreLoweredToNothingElse) {
  const auto lowered = lower(scene_with(kAll), {"G1", "G2", "D1", "D2", "D3"});
  ASSERT_TRUE(std::holds_alternative<Scene>(lowered));
  EXPECT_EQ(std::get<Scene>(lowered).lights, scene_with(kAll).lights);
  const auto refused = lower(scene_with(kAll), {"G1", "G2", "D1", "L4", "D3"});
  ASSERT_TRUE(std::holds_alternative<std::string>(refused));
  EXPECT_EQ(std::get<std::string>(refused), "light 's' is a spot, which needs D2");
}

TEST(LightsWithoutArea, GrowWithTheSquareOfTheWorldButParallelLightDoesNot) {
  const auto large = moved(scene_with(kAll), scaling({4, 4, 4}));
  EXPECT_EQ(large.lights[0].radiance, (RgbColour{48, 32, 16}));
  EXPECT_EQ(large.lights[1].radiance, (RgbColour{16, 16, 16}));
  EXPECT_EQ(large.lights[2].radiance, (RgbColour{1, 1, 1}));
  EXPECT_EQ(with_emission_times(scene_with(kAll), 2).lights[2].radiance, (RgbColour{2, 2, 2}));
}

TEST(LightsWithoutArea, TakeNoRoom) {
  EXPECT_FALSE(world_bounds(scene_with(kSun)));
  EXPECT_EQ(world_bounds(scene_with(kPoint)).value().low, world_bounds(scene_with(kPoint)).value().high);
  const auto vast = vast_objects(scene_with(kAll), 256);
  EXPECT_EQ(vast.lights, (std::vector<bool>{false, false, false}));
}

TEST(LightsWithoutArea, AreSeenNowhereAndLoseNothingWithoutMis) {
  EXPECT_EQ(seen_by_most(scene_with(kAll), {{{512, 512}}}), (std::vector<std::string>{""}));
  EXPECT_NE(why_fault_changes_nothing(scene_with(kAll), RenderFault::NoMisWeight), "");
}

}  // namespace
