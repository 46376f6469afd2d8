// Cameras beyond the pinhole in scene files: read, written, refused, scaled; what they call for.
#include "base/error.h"
#include "scene/camera_frame.h"
#include "scene/effects/features.h"
#include "scene/load/load_scene.h"
#include "scene/load/write_scene.h"
#include "scene/lower/lower.h"
#include "scene/relations/ground.h"
#include "scene/relations/motion.h"
#include "scene/seen_at.h"
#include "structure/source_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr const char* kLens = R"("fov_y": 30, "focus_distance": 3, "aperture_radius": 0.2)";
constexpr const char* kShift = R"("shift": [0.25, -0.5])";
constexpr const char* kOrthographic = R"("projection": "orthographic", "view_height": 2)";
constexpr const char* kAround = R"("projection": "latitude_longitude")";

// A sheet from (0, 0) to (1, 1) at z = 0, seen from z = 9.
scene::Scene read(const std::string& keys) {
  return scene::load_scene_text("scene.json",
                                fmt::format(R"({{"format": "orbs-scene/1", "name": "s",
"camera": {{"position": [0, 0, 9], "look_at": [0, 0, 0], "width": 40, "height": 20, {}}},
"materials": [{{"name": "m", "type": "lambert", "reflectance": [0.5, 0.4, 0.3]}}],
"meshes": [{{"name": "sheet", "positions": [0, 0, 0, 2, 0, 0, 0, 2, 0], "normals": [0, 0, 1, 0, 0, 1, 0, 0, 1],
             "triangles": [0, 1, 2], "material": "m"}}],
"instances": [{{"mesh": "sheet"}}]}})",
                                            keys),
                                ".");
}

void expect_refusal(const std::string& keys, const std::string& part) {
  try {
    read(keys);
    ADD_FAILURE() << "no error where expected: " << part;
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
}

std::string levels(const std::string& keys) {
  std::string out;
  for (const auto& feature : scene::features_called_for(read(keys)))
    if (feature.requirement.front() == 'C') out += feature.requirement;
  return out;
}

}  // namespace

TEST(Projections, AreWhatTheyWereAfterWritingAndReading) {
  const structure::TestFolder folder("projections");
  for (const char* keys : {kLens, kShift, kOrthographic, kAround}) {
    const auto scene = read(keys);
    scene::write_scene(scene, folder.path() / "scene.json");
    EXPECT_EQ(scene::load_scene(folder.path() / "scene.json"), scene) << keys;
  }
  EXPECT_EQ(read(R"("aperture_radius": 0)"), read(R"("fov_y": 90)")) << "a lens without a size is a pinhole";
}

TEST(Projections, CallForTheirLevels) {
  EXPECT_EQ(levels(R"("fov_y": 30, "focus_distance": 3)"), "");
  EXPECT_EQ(levels(kLens), "C1");
  EXPECT_EQ(levels(kOrthographic), "C2");
  EXPECT_EQ(levels(kShift), "C3");
  EXPECT_EQ(levels(kAround), "C4");
  const auto lowered = scene::lower(read(kLens), {"G3", "G4", "G5"});
  ASSERT_TRUE(std::holds_alternative<std::string>(lowered));
  EXPECT_EQ(std::get<std::string>(lowered), "the camera has a lens, which needs C1");
}

TEST(Projections, KeysOfAnotherOneAreRefused) {
  expect_refusal(R"("aperture_radius": 0.1)", "needs a 'focus_distance'");
  expect_refusal(R"("projection": "orthographic")", "view_height");
  expect_refusal(R"("view_height": 2)", "is for an orthographic camera");
  expect_refusal(std::string(kOrthographic) + R"(, "fov_y": 40)",
                 "is for a perspective, and the camera is orthographic");
  expect_refusal(std::string(kAround) + R"(, "shift": [0, 0.1])", "is for a perspective");
  expect_refusal(std::string(kAround) + R"(, "aperture_radius": 0.1)", "is for a perspective");
  expect_refusal(R"("projection": "latitude_longitud")", "latitude_longitude");
  expect_refusal(R"("shift": [0])", "shift");
}

TEST(Projections, GrowWithTheWorld) {
  const auto lens = scene::moved(read(kLens), scaling({4, 4, 4})).camera;
  EXPECT_DOUBLE_EQ(lens.aperture_radius_m, 0.8);
  EXPECT_DOUBLE_EQ(*lens.focus_distance_m, 12);
  const auto flat = scene::moved(read(kOrthographic), scaling({4, 4, 4})).camera;
  EXPECT_DOUBLE_EQ(std::get<scene::Orthographic>(flat.projection).height_m, 8);
  EXPECT_EQ(scene::moved(read(kShift), scaling({4, 4, 4})).camera.shift, (Vec2d{0.25, -0.5}));
  EXPECT_TRUE(std::holds_alternative<std::string>(scene::with_far_camera(read(kOrthographic), 10)));
}

// The sheet lies in the upper right, up to (2, 2): 4 high are 20 pixels of an orthographic image, and the
// camera that looks at z = 0 from 9 m sees 2 * 9 tan(45) of it.
TEST(Projections, SeeTheSheetWhereItIs) {
  const auto sees = [](const std::string& keys, double x, double y) {
    return scene::seen_by_most(read(keys), {{{x, y}}}).front() == "sheet";
  };
  constexpr const char* kFour = R"("projection": "orthographic", "view_height": 4)";
  EXPECT_TRUE(sees(kFour, 21, 9));
  EXPECT_TRUE(sees(kFour, 28.5, 9.5));
  EXPECT_FALSE(sees(kFour, 19, 9));
  EXPECT_FALSE(sees(kFour, 21, 11));
  // A quarter of 40 pixels to the left and half of 20 upwards.
  EXPECT_TRUE(sees(R"("fov_y": 90)", 20.5, 9.5));
  EXPECT_TRUE(sees(R"("fov_y": 90, "shift": [0.25, -0.25])", 10.5, 4.5));
  EXPECT_FALSE(sees(R"("fov_y": 90, "shift": [0.25, -0.25])", 20.5, 9.5));
  EXPECT_TRUE(sees(kAround, 20.2, 9.8));
  EXPECT_FALSE(sees(kAround, 0.2, 9.8));
}
