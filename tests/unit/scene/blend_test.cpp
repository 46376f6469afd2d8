// What a blend may name.
#include "base/error.h"
#include "base/files.h"
#include "scene/geometry/generators.h"
#include "scene/load/load_scene.h"
#include "scene/lower/lower.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;

scene::Scene loaded(const std::string& materials) {
  const ScratchFolder folder{"orbs-blend"};
  write_file(
      folder.path() / "scene.json",
      R"({"format": "orbs-scene/1", "name": "s", "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0]},
"materials": [)" +
          materials + "]}");
  return scene::load_scene(folder.path() / "scene.json", {}, {});
}

std::string complaint(const std::string& materials) {
  try {
    loaded(materials);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

constexpr const char* kMatt = R"({"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]})";

}  // namespace

TEST(Blend, NamesMaterialsThatStandBeforeIt) {
  const auto scene =
      loaded(std::string(kMatt) + R"(, {"name": "g", "type": "mirror", "reflectance": [1, 1, 1]},
{"name": "b", "type": "blend", "first": "g", "second": "m", "weight": 0.25})");
  const auto& blend = std::get<scene::Blend>(scene.materials.back().model);
  EXPECT_EQ(blend.parts[0].material, 1);
  EXPECT_EQ(blend.parts[1].material, 0);
  EXPECT_NE(complaint(std::string(kMatt) +
                      R"(, {"name": "b", "type": "blend", "first": "m", "second": "b", "weight": 1})")
                .find("must name a material that stands before this one"),
            std::string::npos);
}

TEST(Blend, HasNoPartsThatEmitOrBlend) {
  EXPECT_NE(complaint(std::string(kMatt) + R"(, {"name": "e", "type": "emission", "radiance": [1, 1, 1]},
{"name": "b", "type": "blend", "first": "m", "second": "e", "weight": 1})")
                .find("'e' is of type emission"),
            std::string::npos);
}

// They would say nothing: the blend lets rays pass, and turns its normals, by its own.
TEST(Blend, HasNoPartsWithOpacityOrNormalMaps) {
  EXPECT_NE(complaint(R"({"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5], "opacity": 0.5}, )"
                      R"({"name": "n", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}, )"
                      R"({"name": "b", "type": "blend", "first": "n", "second": "m", "weight": 1})")
                .find("'m' has its own"),
            std::string::npos);
}

// A surface shows the textures of its parts.
TEST(Blend, TakesTheTextureMatricesOfItsPartsAlong) {
  scene::Scene scene;
  scene.textures = {{"t", "t.png"}};
  const scene::TextureUse twice{0, scaling({2, 3, 1})};
  scene.materials = {{"first", scene::Lambert{{1, 1, 1}, twice}},
                     {"second", scene::Lambert{{1, 1, 1}, twice}},
                     {"both", scene::Blend{{scene::Blend::Part{"first", 0}, {"second", 1}}, 0.5, {}}}};
  scene.meshes = {scene::make_plane({1})};
  scene.meshes[0].triangle_materials.assign(2, 2);
  scene.instances = {{"i", 0, {}, {}}};
  EXPECT_EQ(scene::texture_matrices_problem(scene, 2), "");
  auto baked = scene;
  scene::bake_texture_matrices(baked);
  EXPECT_EQ(std::get<scene::Lambert>(baked.materials[0].model).texture->matrix, Mat4{});
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2f was = scene.meshes[0].uvs[scene.meshes[0].triangles[i][k]];
      EXPECT_EQ(baked.meshes[0].uvs[baked.meshes[0].triangles[i][k]], (Vec2f{2 * was.x, 3 * was.y}));
    }
  std::get<scene::Lambert>(scene.materials[1].model).texture->matrix = {};
  EXPECT_EQ(scene::texture_matrices_problem(scene, 2),
            "material 'both' has textures with different matrices");
}
