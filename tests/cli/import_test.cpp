// orbs import: from a file to a case that is judged.
#include "adapters/gltf/gltf.h"
#include "base/files.h"
#include "cli/sandbox.h"
#include "scene/load/load_scene.h"

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::contains;
using cli_tests::Sandbox;

namespace {

constexpr const char* kLamp = R"({"format": "orbs-scene/1", "name": "lamp",
 "camera": {"position": [0,0,3], "look_at": [0,0,0], "fov_y": 45, "width": 16, "height": 8},
 "materials": [{"name": "paint", "type": "metallic_roughness", "base_colour": [0.5,0.4,0.3], "metallic": 0, "roughness": 1},
               {"name": "lamp", "type": "emission", "radiance": [2,2,2]}],
 "meshes": [{"name": "wall", "generator": "plane", "half_size": 5, "material": "paint"},
            {"name": "glow", "generator": "plane", "half_size": 5, "material": "lamp"}],
 "instances": [{"mesh": "wall", "matrix": [{"rotate_x": 90}]},
               {"mesh": "glow", "matrix": [{"translate": [0,0,9]}, {"rotate_x": 90}]}]})";

void write_lamp(const Sandbox& sandbox) {
  const auto scene = scene::load_scene_text("lamp.json", kLamp, sandbox.folder());
  adapters::write_gltf(scene, sandbox.folder() / "My lamp.glb");
}

}  // namespace

TEST(Import, MakesACaseThatIsJudged) {
  const Sandbox sandbox;
  write_lamp(sandbox);
  const auto made = sandbox.orbs({"import", "My lamp.glb", "--reference"});
  EXPECT_EQ(made.status, 0) << made.text;
  EXPECT_TRUE(contains(made.text, "16 x 8 pixels, 2 meshes, 4 triangles, 2 instances, 2 materials"))
      << made.text;
  EXPECT_TRUE(contains(made.text, "all of the file was understood")) << made.text;
  EXPECT_TRUE(contains(made.text, "noise ")) << made.text;
  EXPECT_TRUE(contains(made.text, "orbs run --suite mine --scene My_lamp")) << made.text;
  const auto run =
      sandbox.orbs({"run", "--configuration", "my-cases/configuration.json", "-r", "orbs", "-o", "out"});
  EXPECT_EQ(run.status, 0) << run.text;
  EXPECT_TRUE(contains(run.text, "right on its target")) << run.text;
}

TEST(Import, KeepsWhatIsThereUnlessItIsToBeReplaced) {
  const Sandbox sandbox;
  write_lamp(sandbox);
  EXPECT_EQ(sandbox.orbs({"import", "My lamp.glb"}).status, 0);
  const auto configuration = sandbox.read("my-cases/configuration.json");
  const auto again = sandbox.orbs({"import", "My lamp.glb"});
  EXPECT_EQ(again.status, 2) << again.text;
  EXPECT_TRUE(contains(again.text, "is there already")) << again.text;
  EXPECT_EQ(sandbox.orbs({"import", "My lamp.glb", "--replace"}).status, 0);
  EXPECT_EQ(sandbox.read("my-cases/configuration.json"), configuration);
  EXPECT_EQ(sandbox.orbs({"import", "My lamp.glb", "--suite", "theirs"}).status, 0);
  EXPECT_TRUE(sandbox.has("my-cases/cases/theirs/My_lamp/scene.json"));
  EXPECT_TRUE(sandbox.has("my-cases/cases/mine/My_lamp/scene.json"));
  EXPECT_TRUE(contains(sandbox.read("my-cases/configuration.json"), "references/theirs"));
}

TEST(Import, LeavesNothingOfAFileThatIsRefused) {
  const Sandbox sandbox;
  write_lamp(sandbox);
  const auto whole = sandbox.read("My lamp.glb");
  sandbox.write("torn.glb", whole.substr(0, whole.size() - 5));
  const auto torn = sandbox.orbs({"import", "torn.glb"});
  EXPECT_EQ(torn.status, 2) << torn.text;
  EXPECT_TRUE(contains(torn.text, "torn")) << torn.text;
  EXPECT_EQ(sandbox.orbs({"import", "nowhere.glb"}).status, 2);
  EXPECT_EQ(sandbox.orbs({"import", "My lamp.glb", "--requirement", "Q9"}).status, 2);
  EXPECT_EQ(sandbox.orbs({"import", "My lamp.glb", "--name", "../up"}).status, 2);
  EXPECT_EQ(sandbox.orbs({"import", "My lamp.glb", "--camera", "none"}).status, 2);
  EXPECT_FALSE(sandbox.has("my-cases"));
}
