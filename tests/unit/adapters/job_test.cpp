#include "adapters/job.h"

#include "adapters/export.h"
#include "adapters/transports.h"
#include "base/error.h"

#include <gtest/gtest.h>

using orbs::adapters::make_job;
using orbs::registry::Renderer;

namespace {

Renderer renderer_with(std::vector<std::string> command) {
  Renderer renderer;
  renderer.name = std::string("r");
  renderer.command.words = std::move(command);
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
                     "{width}x{height}", "{trace_depth}", "{transport}", "{root}", "{build}"});
  const auto job =
      make_job(renderer, scene_of(64, 48), {128, 3, 2, "/base", "/build", "/bin/r"}, "/out/r/101");
  EXPECT_EQ(job.argv, (std::vector<std::string>{"/bin/r", "/out/r/101/scene.json",
                                                "--out=/out/r/101/result.exr", "/out/r/101", "128", "3", "2",
                                                "64x48", "6", "rgb", "/base", "/build"}));
  EXPECT_EQ(job.image, "/out/r/101/result.exr");
  EXPECT_EQ(job.width_px, 64);
  EXPECT_EQ(job.height_px, 48);
}

TEST(Job, SeedsStandAsFarApartAsTheRendererNeedsThem) {
  auto renderer = renderer_with({"{executable}", "{scene}", "{output}", "{seed}"});
  renderer.sampling.seed_stride = 1000003;
  EXPECT_EQ(make_job(renderer, scene_of(1, 1), {1, 2, 1, "", "", "/r"}, "/o").argv.back(), "2000006");
  EXPECT_THROW(make_job(renderer, scene_of(1, 1), {1, 5000, 1, "", "", "/r"}, "/o"), orbs::InputError);
}

// A program without a seed draws other random numbers for each further image of one run.
TEST(Job, TheSeedOfAnImageSequenceIsTheNumberOfItsImages) {
  auto renderer = renderer_with({"{executable}", "{scene}", "{output}", "{images}", "{spp}"});
  renderer.command.sequence = {{"-cam_id", "0"}, "_cam_000"};
  const auto first = make_job(renderer, scene_of(1, 1), {4, 1, 1, "", "", "/r"}, "/o");
  EXPECT_EQ(first.argv,
            (std::vector<std::string>{"/r", "/o/scene.json", "/o/result.exr", "-cam_id", "0", "4"}));
  EXPECT_EQ(first.image, "/o/result.exr");
  const auto third = make_job(renderer, scene_of(1, 1), {4, 3, 1, "", "", "/r", "seed-3.exr"}, "/o");
  EXPECT_EQ(third.argv, (std::vector<std::string>{"/r", "/o/scene.json", "/o/seed-3.exr", "-cam_id", "0",
                                                  "-cam_id", "0", "-cam_id", "0", "4"}));
  EXPECT_EQ(third.image, "/o/seed-3_cam_000.exr");
  EXPECT_THROW(make_job(renderer, scene_of(1, 1), {4, 101, 1, "", "", "/r"}, "/o"), orbs::InputError);
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
  renderer.format.name = "povray";
  renderer.format.settings["photons"] = 1000;
  EXPECT_NO_THROW(orbs::adapters::check_scene_settings(renderer));
  renderer.format.settings["photon"] = 1000;
  EXPECT_THROW(orbs::adapters::check_scene_settings(renderer), orbs::InputError);
  renderer.format.settings = {{"photons", 0.5}};
  EXPECT_THROW(orbs::adapters::check_scene_settings(renderer), orbs::InputError);
  renderer.format.settings = {{"photons", 1}};
  renderer.format.name = "orbs-scene";
  EXPECT_THROW(orbs::adapters::check_scene_settings(renderer), orbs::InputError);
}

namespace {

orbs::scene::Scene polarised_scene() {
  auto scene = scene_of(8, 8);
  scene.outputs.stokes = true;
  return scene;
}

}  // namespace

TEST(Transports, TheCommandGetsTheRenderersWordForWhatTheSceneCallsFor) {
  auto renderer = renderer_with({"{executable}", "-m", "{transport}", "{scene}", "{output}"});
  EXPECT_EQ(make_job(renderer, polarised_scene(), {}, "/o").argv[2], "polarised");
  renderer.format.transports = {{"rgb", "scalar_rgb"}, {"polarised", "scalar_spectral_polarized"}};
  EXPECT_EQ(make_job(renderer, polarised_scene(), {}, "/o").argv[2], "scalar_spectral_polarized");
  EXPECT_EQ(make_job(renderer, scene_of(8, 8), {}, "/o").argv[2], "scalar_rgb");
}

TEST(Transports, ASceneThatTheRendererHasNoWordForIsRefusedWithTheReason) {
  auto renderer = renderer_with({"{transport}"});
  renderer.support.declares = orbs::registry::parse_features("G5/M8/L4/A4/E6");
  EXPECT_EQ(orbs::adapters::transport_limit(renderer, polarised_scene()), "");
  renderer.format.transports = {{"rgb", "scalar_rgb"}};
  EXPECT_EQ(orbs::adapters::transport_limit(renderer, scene_of(8, 8)), "");
  const auto prepared = orbs::adapters::prepare_scene(renderer, polarised_scene());
  ASSERT_TRUE(std::holds_alternative<std::string>(prepared));
  EXPECT_EQ(std::get<std::string>(prepared),
            "it calls for polarised light paths because the image holds Stokes vectors, for which the "
            "renderer's 'transports' has no word");
}

TEST(Transports, WordsForPathsThatDoNotExistOrThatNobodyUsesAreErrors) {
  auto renderer = renderer_with({"{executable}", "{transport}"});
  renderer.format.transports = {{"spectral", "s"}};
  EXPECT_NO_THROW(orbs::adapters::check_transports(renderer));
  renderer.format.transports = {{"polarized", "p"}};
  try {
    orbs::adapters::check_transports(renderer);
    FAIL() << "'polarized' passed";
  } catch (const orbs::InputError& e) {
    EXPECT_NE(std::string(e.what()).find("polarised"), std::string::npos) << e.what();
  }
  renderer.format.transports = {{"spectral", "s"}};
  renderer.command.words = {"{executable}"};
  EXPECT_THROW(orbs::adapters::check_transports(renderer), orbs::InputError);
}
