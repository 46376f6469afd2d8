// What a blend may name.
#include "base/error.h"
#include "base/files.h"
#include "scene/load/load_scene.h"

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
