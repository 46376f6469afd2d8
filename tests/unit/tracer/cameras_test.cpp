// Several cameras in one scene file: each gives the scene, and the image to the bit, of a file that has it
// alone.
#include "base/error.h"
#include "base/files.h"
#include "registry/case.h"
#include "registry/cases.h"
#include "run/plan/scenes.h"
#include "scene/load/write_scene.h"
#include "structure/source_files.h"
#include "unit/tracer/scenes.h"

#include <atomic>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;

namespace {

// The cameras of data/cases/known/g2_cameras/cameras.json; "" is the one without a name.
const std::map<std::string, std::string> kCameras{
    {"", R"({"position": [3, 2.5, 2], "look_at": [0, 0, 0], "fov_y": 35, "width": 64, "height": 64})"},
    {"behind",
     R"({"position": [-4, 1.5, -1], "look_at": [-0.5, 0.3, 0.2], "fov_y": 30, "width": 96, "height": 48})"},
    {"above",
     R"({"position": [0, 4, 0.3], "look_at": [0, 0, 0.3], "up": [1, 0, 0], "fov_y": 40, "width": 48, "height": 48})"}};

constexpr const char* kFile = ORBS_SOURCE_DIR "/data/cases/known/g2_cameras/cameras.json";

// The file with one camera in place of all.
std::string with_one_camera(const std::string& camera) {
  auto text = read_file(kFile);
  const auto begin = text.find(R"("camera")");
  const auto end = text.find(R"("materials")");
  return text.replace(begin, end - begin, fmt::format(R"("camera": {}, )", camera));
}

scene::Scene read(const std::string& cameras, const std::string& chosen) {
  return scene::load_scene_text(
      "s.json", fmt::format(R"({{"format": "orbs-scene/1", "name": "s", {}"materials": []}})", cameras), ".",
      {}, chosen);
}

std::string refusal(const std::string& cameras, const std::string& chosen) {
  try {
    read(cameras, chosen);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

std::vector<float> pixels_of(const scene::Scene& scene) {
  const std::atomic<bool> never{false};
  return tracer::render(tracer::make_world(scene), {.samples_per_pixel = 4}, never,
                        [](const tracer::Progress&) {})
      .image.pixels;
}

constexpr const char* kTwo =
    R"("cameras": {"left": {"position": [-1, 0, 5], "look_at": [0, 0, 0]},
                   "right": {"position": [1, 0, 5], "look_at": [0, 0, 0]}}, )";
constexpr const char* kOwn = R"("camera": {"position": [0, 0, 9], "look_at": [0, 0, 0]}, )";

}  // namespace

TEST(Cameras, EachGivesTheImageOfAFileThatHasItAlone) {
  for (const auto& [name, camera] : kCameras) {
    const auto chosen = scene::load_scene(kFile, {}, name);
    const auto alone = scene::load_scene_text("one.json", with_one_camera(camera),
                                              std::filesystem::path(kFile).parent_path());
    EXPECT_EQ(chosen, alone) << name;
    EXPECT_EQ(pixels_of(chosen), pixels_of(alone)) << name;
  }
}

// What a renderer is given has one camera, the chosen one.
TEST(Cameras, OneIsWritten) {
  const structure::TestFolder folder("cameras");
  scene::write_scene(read(std::string(kOwn) + kTwo, "right"), folder.path() / "s.json");
  EXPECT_EQ(read_file(folder.path() / "s.json").find("cameras"), std::string::npos);
  EXPECT_EQ(scene::load_scene(folder.path() / "s.json").camera.position_m, (Vec3d{1, 0, 5}));
}

TEST(Cameras, AreChosenByName) {
  EXPECT_EQ(read(std::string(kOwn) + kTwo, "").camera.position_m, (Vec3d{0, 0, 9}));
  EXPECT_EQ(read(std::string(kOwn) + kTwo, "left").camera.position_m, (Vec3d{-1, 0, 5}));
  EXPECT_EQ(read(kTwo, "right").camera.position_m, (Vec3d{1, 0, 5}));
}

TEST(Cameras, RefusalsNameThoseThatAreThere) {
  expect_part(refusal(kTwo, ""),
              "has several cameras and none without a name; choose one, by \"camera\" in the "
              "scene's entry of case.json or by --camera of orbs-tracer; there are: left, right");
  expect_part(refusal(kTwo, "lef"),
              "there is no camera 'lef' (did you mean 'left'?); there are: left, right");
  expect_part(refusal(kOwn, "left"), "there is no camera 'left'; the file has no \"cameras\"");
  expect_part(refusal("", ""), "key 'camera' is missing");
  expect_part(refusal(R"("cameras": {}, )", ""), "must hold at least one camera by its name");
  expect_part(refusal(R"("cameras": {"../a": {"position": [0, 0, 5], "look_at": [0, 0, 0]}}, )", "../a"),
              "is no plain name");
  // Those that are not chosen are checked, too.
  expect_part(
      refusal(std::string(kOwn) + R"("cameras": {"a": {"position": [0, 0, 0], "look_at": [0, 0, 0]}}, )", ""),
      "/cameras/a/look_at: must differ from position");
}

// A reference of one camera is none of another.
TEST(Cameras, ChangeTheHashOfTheScene) {
  const auto hash = [](const std::string& camera) {
    return run::scene_content_hash(scene::load_scene(kFile, {}, camera), kFile);
  };
  EXPECT_NE(hash("behind"), hash("above"));
  EXPECT_NE(hash(""), hash("above"));
  EXPECT_EQ(hash("above"), hash("above"));
}

TEST(Cameras, AreNamedByTheScenesOfACase) {
  const auto one_case = registry::load_case(ORBS_SOURCE_DIR "/data/cases/known/g2_cameras/case.json");
  ASSERT_EQ(one_case.scenes.size(), 3U);
  EXPECT_EQ(one_case.scenes[0].camera, "");
  EXPECT_EQ(one_case.scenes[1].camera, "behind");
  EXPECT_EQ(one_case.scenes[0].file, one_case.scenes[1].file);
}
