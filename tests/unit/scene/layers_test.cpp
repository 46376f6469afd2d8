// Layers of surfaces in scene files: read, written, called for, refused.
#include "base/error.h"
#include "scene/effects/features.h"
#include "scene/load/load_scene.h"
#include "scene/load/write_scene.h"
#include "structure/source_files.h"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;

namespace {

scene::Scene scene_with(const std::string& layers, const std::string& more = "") {
  return scene::load_scene_text("scene.json",
                                fmt::format(R"({{"format": "orbs-scene/1", "name": "s",
"camera": {{"position": [0, 0, 5], "look_at": [0, 0, 0]}},
"materials": [{{"name": "m", "type": "lambert", "reflectance": [0.5, 0.4, 0.3]}}],
"outputs": {{"layers": {}}}{}}})",
                                            layers, more),
                                ".");
}

void expect_refusal(const std::string& layers, const std::string& part, const std::string& more = "") {
  try {
    scene_with(layers, more);
    ADD_FAILURE() << "no error in " << layers << more;
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
}

}  // namespace

TEST(SceneLayers, AreReadAndWritten) {
  const structure::TestFolder folder("layers");
  for (const char* more : {"", R"(, "integrator": {"type": "ambient_occlusion"})",
                           R"(, "integrator": {"type": "irradiance_cache"})"}) {
    const auto scene = scene_with(R"(["normal", "depth"])", more);
    EXPECT_EQ(scene.outputs.layers, (std::vector<std::string>{"normal", "depth"}));
    scene::write_scene(scene, folder.path() / "scene.json");
    EXPECT_EQ(scene::load_scene(folder.path() / "scene.json"), scene) << more;
  }
}

TEST(SceneLayers, CallForV1) {
  const auto is_called = [](const scene::Scene& scene) {
    const auto found = scene::features_called_for(scene);
    return std::any_of(found.begin(), found.end(),
                       [](const auto& feature) { return feature.requirement == "V1"; });
  };
  EXPECT_TRUE(is_called(scene_with(R"(["uv"])")));
  EXPECT_FALSE(is_called(scene_with("[]")));
}

TEST(SceneLayers, UnknownOnesAndTwinsAreRefused) {
  expect_refusal(R"(["normals"])", "there is no layer 'normals' (did you mean 'normal'?)");
  expect_refusal(R"(["depth", "depth"])", "layer 'depth' is named twice");
}

TEST(SceneLayers, AnAlbedoOfSpectraIsRefused) {
  const char* const spectra = R"(, "spectra": [{"name": "e", "constant": 1}])";
  expect_refusal(R"(["albedo"])", "the scene has spectra", spectra);
  EXPECT_EQ(scene_with(R"(["normal"])", spectra).outputs.layers.size(), 1U);
}
