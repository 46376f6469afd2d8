#include "adapters/export.h"
#include "adapters/job.h"
#include "base/error.h"

#include <gtest/gtest.h>

using orbs::adapters::make_job;
using orbs::registry::Renderer;

namespace {

Renderer renderer_with(std::vector<std::string> command) {
  Renderer renderer;
  renderer.name = std::string("r");
  renderer.command = std::move(command);
  return renderer;
}

orbs::scene::Scene scene_of(int width, int height) {
  orbs::scene::Scene scene;
  scene.camera.width_px = width;
  scene.camera.height_px = height;
  scene.trace_depth = 6;
  return scene;
}

}  // namespace

TEST(Job, EveryPlaceholderHasItsValue) {
  const auto renderer =
      renderer_with({"{executable}", "{scene}", "--out={output}", "{folder}", "{spp}", "{seed}", "{threads}",
                     "{width}x{height}", "{trace_depth}", "{root}", "{build}"});
  const auto job =
      make_job(renderer, scene_of(64, 48), {128, 3, 2, "/base", "/build", "/bin/r"}, "/out/r/101");
  EXPECT_EQ(job.argv,
            (std::vector<std::string>{"/bin/r", "/out/r/101/scene.json", "--out=/out/r/101/result.exr",
                                      "/out/r/101", "128", "3", "2", "64x48", "6", "/base", "/build"}));
  EXPECT_EQ(job.image, "/out/r/101/result.exr");
  EXPECT_EQ(job.width_px, 64);
  EXPECT_EQ(job.height_px, 48);
}

// A path with spaces or shell characters is one argument, since there is no shell.
TEST(Job, APathWithSpacesStaysOneArgument) {
  const auto job = make_job(renderer_with({"{executable}", "{scene}", "{output}"}), scene_of(1, 1),
                            {1, 1, 1, "", "", "/a b/r"}, "/o $x; y");
  ASSERT_EQ(job.argv.size(), 3U);
  EXPECT_EQ(job.argv[1], "/o $x; y/scene.json");
}

TEST(Job, SamplesScaleWithTheRendererAndTheRunAndStayAtLeastOne) {
  EXPECT_EQ(orbs::adapters::scaled_spp(128, 0.5, 0.25), 16);
  EXPECT_EQ(orbs::adapters::scaled_spp(128, 1, 0.001), 1);
  EXPECT_EQ(orbs::adapters::scaled_spp(3, 0.5, 1), 2);
}

TEST(Job, MoreSamplesThanACountCanHoldAreRefused) {
  EXPECT_THROW(orbs::adapters::scaled_spp(128, 1e300, 1), orbs::InputError);
  EXPECT_THROW(orbs::adapters::scaled_spp(128, 1e300, 1e300), orbs::InputError);
  EXPECT_EQ(orbs::adapters::scaled_spp(1 << 20, 1024, 1), 1 << 30);
}

TEST(Export, ASettingThatTheFormatDoesNotHaveIsAnError) {
  auto renderer = renderer_with({});
  renderer.scene_format = orbs::registry::SceneFormat::Povray;
  renderer.scene_settings["photons"] = 1000;
  EXPECT_NO_THROW(orbs::adapters::check_scene_settings(renderer));
  renderer.scene_settings["photon"] = 1000;
  EXPECT_THROW(orbs::adapters::check_scene_settings(renderer), orbs::InputError);
  renderer.scene_settings = {{"photons", 0.5}};
  EXPECT_THROW(orbs::adapters::check_scene_settings(renderer), orbs::InputError);
  renderer.scene_settings = {{"photons", 1}};
  renderer.scene_format = orbs::registry::SceneFormat::OrbsScene;
  EXPECT_THROW(orbs::adapters::check_scene_settings(renderer), orbs::InputError);
}
