// Second texture coordinates: where they are read, kept and asked for.
#include "base/error.h"
#include "base/files.h"
#include "scene/load/load_scene.h"
#include "scene/load/write_scene.h"
#include "scene/lower/geometry.h"
#include "scene/lower/lower.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;

constexpr const char* kSecond = R"("second_uvs": [0.5, 0, 0.5, 1, 0, 1],)";

// A triangle, with these keys of its mesh and this texture of its material.
std::string text_with(const std::string& of_mesh, const std::string& texture) {
  return fmt::format(
      R"({{"format": "orbs-scene/1", "name": "s", "camera": {{"position": [0, 0, 5], "look_at": [0, 0, 0]}},
"textures": [{{"name": "four", "file": "{}/data/common/textures/four_colours.png"}}],
"materials": [{{"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5], "texture": {}}}],
"meshes": [{{"name": "t", "positions": [0, 0, 0, 1, 0, 0, 0, 1, 0], "normals": [0, 0, 1, 0, 0, 1, 0, 0, 1],
"uvs": [0, 0, 1, 0, 0, 1], {} "triangles": [0, 1, 2], "material": "m"}}],
"instances": [{{"name": "t", "mesh": "t"}}]}})",
      ORBS_SOURCE_DIR, texture, of_mesh);
}

scene::Scene loaded(const std::string& text) {
  const ScratchFolder folder{"orbs-second-uvs"};
  write_file(folder.path() / "scene.json", text);
  return scene::load_scene(folder.path() / "scene.json", {}, {});
}

std::string complaint(const std::string& text) {
  try {
    loaded(text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

scene::Scene at_second(const std::string& more = "") {
  return loaded(text_with(kSecond, R"({"name": "four", "uv_set": 1)" + more + "}"));
}

const std::vector<Vec2f> kUvs{{0.5F, 0}, {0.5F, 1}, {0, 1}};

}  // namespace

TEST(SecondUvs, AreReadAndWritten) {
  const auto scene = at_second();
  EXPECT_EQ(scene.meshes.at(0).second_uvs, kUvs);
  EXPECT_EQ(texture_of(scene.materials.at(0).model)->uv_set, 1);
  EXPECT_TRUE(loaded(text_with("", R"("four")")).meshes.at(0).second_uvs.empty());
  const ScratchFolder folder{"orbs-second-uvs-written"};
  scene::write_scene(scene, folder.path() / "scene.json");
  const auto again = scene::load_scene(folder.path() / "scene.json", {}, {});
  EXPECT_EQ(again.meshes, scene.meshes);
  EXPECT_EQ(again.materials, scene.materials);
}

TEST(SecondUvs, MustBeThereWhereATextureAsksForThem) {
  EXPECT_TRUE(
      has(complaint(text_with("", R"({"name": "four", "uv_set": 1})")), "mesh 't' has no 'second_uvs'"));
  EXPECT_TRUE(has(complaint(text_with(R"("second_uvs": [0, 0],)", R"("four")")),
                  "there are 3 positions and 1 second texture coordinates"));
  EXPECT_TRUE(has(complaint(text_with(kSecond, R"({"name": "four", "uv_set": 2})")), "uv_set"));
  auto text = text_with(kSecond, R"({"name": "four", "uv_set": 1})");
  text.insert(text.rfind('}'),
              R"(, "shapes": [{"type": "sphere", "centre": [0, 0, 0], "radius": 1, "material": "m"}])");
  EXPECT_TRUE(has(complaint(text), "is a shape by its formula, which has none")) << complaint(text);
}

TEST(SecondUvs, NeedN6) {
  const auto lowered = scene::lower(at_second(), {"G1", "G2", "G3", "G4", "G5", "M1", "M4", "M5", "A1"});
  EXPECT_EQ(std::get<std::string>(lowered),
            "material 'm' has a texture at the second texture coordinates, which needs N6");
}

TEST(SecondUvs, AreNotHandedOutWhereTheyAreNotAskedFor) {
  const auto scene = loaded(text_with(kSecond, R"("four")"));
  const auto lowered = scene::lower(scene, {"G1", "G2", "G3", "G4", "G5", "M1", "M4", "M5", "A1"});
  EXPECT_TRUE(std::get<scene::Scene>(lowered).meshes.at(0).second_uvs.empty());
}

TEST(SecondUvs, TakeUpTextureMatrices) {
  auto scene = at_second(R"(, "matrix": [{"scale": [2, 3, 1]}])");
  scene::bake_texture_matrices(scene);
  EXPECT_EQ(scene.meshes.at(0).second_uvs, (std::vector<Vec2f>{{1, 0}, {1, 3}, {0, 3}}));
  EXPECT_EQ(texture_of(scene.materials.at(0).model)->uv_set, 1);
}

TEST(SecondUvs, AreKeptWhereMeshesAreSplitAndJoined) {
  auto scene = at_second();
  scene.meshes.push_back(loaded(text_with("", R"("four")")).meshes.at(0));
  scene.materials.push_back(loaded(text_with("", R"("four")")).materials.at(0));
  scene.meshes[1].triangle_materials = {1};
  scene.instances.insert(scene.instances.begin(), {"u", 1, {}, {}});
  auto parts = scene;
  scene::split_by_material(parts);
  EXPECT_EQ(parts.meshes.at(0).second_uvs, kUvs);
  scene::merge_into_world_mesh(scene);
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].second_uvs, (std::vector<Vec2f>{{}, {}, {}, {0.5F, 0}, {0.5F, 1}, {0, 1}}));
}
