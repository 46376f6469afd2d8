// Scenes whose numbers are readable and mean nothing that can be rendered.
#include "base/error.h"
#include "scene/load/load_scene.h"
#include "structure/source_files.h"

#include <gtest/gtest.h>

using orbs::structure::TestFolder;

namespace {

std::string refusal(const std::string& camera,
                    const std::string& reflectance,
                    const std::string& more = "",
                    const std::filesystem::path& folder = ".") {
  try {
    orbs::scene::load_scene_text("scene.json",
                                 R"({"format": "orbs-scene/1", "name": "s",
"camera": {"position": [0, 0, 5], "look_at": [0, 0, 0])" +
                                     camera + R"(},
"materials": [{"name": "m", "type": "lambert", "reflectance": )" +
                                     reflectance + R"(}])" + more + "}",
                                 folder);
  } catch (const orbs::InputError& e) {
    return e.what();
  }
  return "no error";
}

constexpr const char* kGrey = "[0.5, 0.5, 0.5]";

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

}  // namespace

TEST(SceneRefusal, TheNearPlaneLiesBeforeTheFarOne) {
  EXPECT_EQ(refusal(R"(, "near": 0.1, "far": 100)", kGrey), "no error");
  expect_part(refusal(R"(, "near": 10, "far": 2)", kGrey),
              "/camera/near: 'near' must be below 'far', they are 10 and 2");
}

TEST(SceneRefusal, ColoursAreThreeNumbersOrASpectrum) {
  expect_part(refusal("", "0.5"),
              "/materials/0/reflectance: must be three numbers or {\"spectrum\": name}, is number");
  expect_part(
      refusal("", kGrey, R"(, "environment": 1)"),
      "/environment: must be [r, g, b], a spectrum, or an object with a radiance or a map, is number");
}

TEST(SceneRefusal, RadianceIsWhatAnImageCanHold) {
  EXPECT_EQ(refusal("", kGrey, R"(, "environment": [1e38, 0, 0])"), "no error");
  expect_part(refusal("", kGrey, R"(, "environment": [0, 1e300, 0])"), "/environment/1: must lie in [0, 3.4");
  expect_part(
      refusal(
          "", kGrey,
          R"(, "spectra": [{"name": "e", "constant": 1e38}], "environment": {"spectrum": "e", "scale": 1e38})"),
      "/environment: reaches ");
}

TEST(SceneRefusal, WhatIsNoFileIsCalledWhatItIs) {
  const TestFolder scratch("scene-no-file");
  scratch.write("folder/inside", "");
  std::filesystem::create_symlink("loop", scratch.path() / "loop");
  const auto texture = [&](const std::string& file) {
    return refusal("", kGrey, R"(, "textures": [{"name": "t", "file": ")" + file + R"("}])", scratch.path());
  };
  expect_part(texture("folder"), "folder is a folder, expected a file");
  expect_part(texture("loop"), "loop is a symbolic link that leads nowhere, expected a file");
  expect_part(texture("none"), "there is no file ");
  expect_part(texture("/dev/null"), "/dev/null is a device or a pipe, expected a file");
}
