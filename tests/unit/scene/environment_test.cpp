#include "base/error.h"
#include "json/writer.h"
#include "scene/effects/effects.h"
#include "scene/effects/features.h"
#include "scene/load/load_scene.h"
#include "scene/relations/light.h"
#include "scene/relations/motion.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::scene;

Scene scene_with(const std::string& environment) {
  return load_scene_text(
      "test.json",
      R"({"format": "orbs-scene/1", "name": "test", "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0]}, )"
      R"("textures": [{"name": "sky", "file": "skies/linear.exr"}], "materials": [], "environment": )" +
          environment + "}",
      ORBS_SOURCE_DIR "/data/common");
}

std::string refusal_of(const std::string& environment) {
  try {
    scene_with(environment);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string codes(const Scene& scene) {
  std::string out;
  for (const auto& feature : features_of_environment(scene)) out += feature.requirement + " ";
  return out;
}

constexpr const char* kTurned = R"({"radiance": [3, 2, 1], "map": "sky", "matrix": [{"rotate_y": 90}]})";

void expect_near(Vec3d a, Vec3d b) { EXPECT_LT(length(a - b), 1e-12) << a.x << " " << a.y << " " << a.z; }

}  // namespace

TEST(Environment, IsReadInAllItsFormsAndWrittenAgain) {
  EXPECT_EQ(scene_with("[1, 2, 3]").environment, (Environment{.radiance = {1, 2, 3}}));
  EXPECT_EQ(scene_with(R"({"radiance": [1, 2, 3], "visible_to_camera": false})").environment,
            (Environment{.radiance = {1, 2, 3}, .visible_to_camera = false}));
  const Environment plain{.radiance = {1, 1, 1}, .map = EnvironmentMap{}};
  EXPECT_EQ(scene_with(R"({"map": "sky"})").environment, plain);
  for (const char* text : {"[1, 2, 3]", kTurned, R"({"map": "sky", "visible_to_camera": false})"}) {
    const auto scene = scene_with(text);
    json::Writer out;
    out.begin_object();
    write_environment(out, scene.spectra, scene.textures, scene.environment);
    const std::string written = out.end_object().text();
    const auto from = written.find(':') + 1;
    EXPECT_EQ(scene_with(written.substr(from, written.rfind('}') - from)).environment, scene.environment)
        << written;
  }
}

TEST(Environment, RefusesWhatItCannotBe) {
  EXPECT_NE(refusal_of(R"({"map": "ground"})").find("there is no texture 'ground'"), std::string::npos)
      << refusal_of(R"({"map": "ground"})");
  EXPECT_NE(refusal_of("{}").find("'radiance' is missing"), std::string::npos) << refusal_of("{}");
  EXPECT_NE(refusal_of(R"({"map": "sky", "sun": 1})").find("sun"), std::string::npos);
  EXPECT_NE(refusal_of(R"({"map": "sky", "radiance": [-1, 0, 0]})").find("radiance"), std::string::npos);
  for (const char* step : {R"({"scale": 2})", R"({"translate": [0, 1, 0]})", R"({"scale": [1, 2, 1]})"})
    EXPECT_NE(
        refusal_of(std::string(R"({"map": "sky", "matrix": [)") + step + "]}").find("must turn or mirror"),
        std::string::npos)
        << step;
  EXPECT_EQ(refusal_of(R"({"map": "sky", "matrix": [{"scale": [-1, 1, 1]}, {"rotate_x": 33.3}]})"), "");
}

TEST(Environment, CallsForItsRequirements) {
  EXPECT_EQ(codes(scene_with("[1, 2, 3]")), "");
  EXPECT_EQ(codes(scene_with(kTurned)), "D5 ");
  EXPECT_EQ(codes(scene_with(R"({"radiance": [1, 1, 1], "visible_to_camera": false})")), "D6 ");
  EXPECT_TRUE(calls_for(effects(scene_with(kTurned)), Effect::EnvironmentMap));
  EXPECT_FALSE(calls_for(effects(scene_with("[1, 2, 3]")), Effect::EnvironmentMap));
}

TEST(Environment, TurnsWithTheWorldAndKeepsItsLight) {
  const Mat4 motion = translation({3, 4, 5}) * rotation_x(30) * scaling({2, 2, 2});
  const auto scene = moved(scene_with(kTurned), motion);
  EXPECT_EQ(scene.environment.radiance, (RgbColour{3, 2, 1}));
  const Mat4 expected = rotation_x(30) * rotation_y(90);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(scene.environment.map->matrix.m[i], expected.m[i], 1e-12);
}

TEST(Environment, MultipliesItsImage) {
  EXPECT_EQ(with_emission_times(scene_with(kTurned), 2).environment.radiance, (RgbColour{6, 4, 2}));
  EXPECT_TRUE(std::holds_alternative<std::string>(with_rotated_channels(scene_with(kTurned))));
}

TEST(Environment, DirectionsLieWhereTheFormatSays) {
  expect_near(map_direction({0.5, 0.5}), {0, 0, -1});
  expect_near(map_direction({0.75, 0.5}), {1, 0, 0});
  expect_near(map_direction({0.25, 0.5}), {-1, 0, 0});
  expect_near(map_direction({0.3, 1}), {0, 1, 0});
  for (const Vec3d d : {Vec3d{1, 2, 3}, Vec3d{-1, 0.1, -4}, Vec3d{0.01, -5, 0.02}})
    expect_near(map_direction(map_coordinates(d)), normalised(d));
}
