// The integrators of scene files: read, written, refused.
#include "base/error.h"
#include "base/matrix.h"
#include "scene/effects/features.h"
#include "scene/load/load_scene.h"
#include "scene/load/write_scene.h"
#include "scene/relations/motion.h"
#include "structure/source_files.h"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;

namespace {

scene::Scene scene_with(const std::string& integrator, const std::string& more = "") {
  return scene::load_scene_text("scene.json",
                                fmt::format(R"({{"format": "orbs-scene/1", "name": "s",
"camera": {{"position": [0, 0, 5], "look_at": [0, 0, 0]}},
"materials": [{{"name": "m", "type": "lambert", "reflectance": [0.5, 0.4, 0.3]}}],
"integrator": {{"type": "irradiance_cache"{}}}{}}})",
                                            integrator, more),
                                ".");
}

void expect_refusal(const std::string& integrator, const std::string& part, const std::string& more = "") {
  try {
    scene_with(integrator, more);
    ADD_FAILURE() << "no error in " << integrator << more;
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
}

}  // namespace

TEST(IrradianceCacheScene, IsReadAndWritten) {
  const auto plain = scene_with("");
  EXPECT_EQ(std::get<scene::IrradianceCache>(plain.integrator), scene::IrradianceCache{});
  EXPECT_EQ(plain.trace_depth, 5);
  const auto full = scene_with(R"(, "trace_depth": "unlimited", "metric": "tabellion_lamorlette", "kappa": 2,
    "rays": 100, "spacing": [1, 7], "gradients": false, "neighbour_clamping": false)");
  EXPECT_EQ(std::get<scene::IrradianceCache>(full.integrator),
            (scene::IrradianceCache{.metric = scene::CacheMetric::TabellionLamorlette,
                                    .kappa = 2,
                                    .rays = 100,
                                    .least_spacing_px = 1,
                                    .most_spacing_px = 7,
                                    .has_gradients = false,
                                    .clamps_to_neighbours = false}));
  const structure::TestFolder folder("integrators");
  for (const auto& scene : {scene_with(R"(, "error": 0.05)"), full}) {
    scene::write_scene(scene, folder.path() / "scene.json");
    EXPECT_EQ(scene::load_scene(folder.path() / "scene.json"), scene);
  }
}

TEST(IrradianceCacheScene, CallsForI2) {
  const auto features = scene::features_called_for(scene_with(""));
  EXPECT_TRUE(std::any_of(features.begin(), features.end(),
                          [](const auto& feature) { return feature.requirement == "I2"; }));
}

// All its lengths are pixels.
TEST(IrradianceCacheScene, DoesNotChangeWithTheScale) {
  const auto scene = scene_with(R"(, "spacing": [1, 7])");
  EXPECT_EQ(scene::moved(scene, scaling({3, 3, 3})).integrator, scene.integrator);
}

TEST(IrradianceCacheScene, RefusalsSayWhereAndWhatToDo) {
  expect_refusal(R"(, "error": 0)", "/integrator/error");
  expect_refusal(R"(, "kappa": 1)", "kappa");
  expect_refusal(R"(, "metric": "tabellion_lamorlette", "error": 0.1)", "error");
  expect_refusal(R"(, "metric": "warp")", "'warp' is not one of");
  expect_refusal(R"(, "rays": 5000)", "/integrator/rays");
  expect_refusal(R"(, "rays": 1)", "/integrator/rays");
  expect_refusal(R"(, "spacing": [5, 2])", "the first number is the least spacing");
  expect_refusal(R"(, "spacing": [5])", "/integrator/spacing");
  expect_refusal(R"(, "distance": 2)", "distance");
  expect_refusal("", "keeps no light paths", R"(, "outputs": {"path_classes": true})");
  expect_refusal("", "calls for spectral transport", R"(, "spectra": [{"name": "a", "illuminant": "A"}],
    "environment": {"spectrum": "a"}, "shapes": [{"type": "sphere", "centre": [0, 0, 0], "radius": 1, "material": "m"}])");
}
