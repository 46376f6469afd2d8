#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "run/job_folder.h"
#include "run/render.h"
#include "structure/source_files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

using namespace orbs;
using structure::TestFolder;

namespace {

// A renderer that notes its seed and samples, does as `line` of the shell says, and leaves an image.
run::ChosenRenderer renderer_in(const std::filesystem::path& folder, const std::string& line) {
  image::write_exr(image::make_image(4, 4, {"R", "G", "B"}), folder / "image.exr");
  const auto program = folder / "render.sh";
  write_file(program, fmt::format("#!/bin/sh\necho \"$2 $3\" >> seeds.txt\n{}\ncp {}/image.exr \"$1\"\n",
                                  line, folder.string()));
  ::chmod(program.c_str(), 0755);
  registry::Renderer entry;
  entry.name = "r";
  entry.support.declares = registry::parse_features("G5/M8/L4/A4");
  entry.command.words = {"{executable}", "{output}", "{seed}", "{spp}", "{scene}"};
  return {entry, program};
}

scene::Scene small_scene() {
  scene::Scene scene;
  scene.camera.width_px = scene.camera.height_px = 4;
  return scene;
}

}  // namespace

// As in a run: the samples are shared, and no seed is given twice.
TEST(RenderOnce, StartsEachSeedReplica) {
  const TestFolder folder("replicas");
  auto renderer = renderer_in(folder.path(), "");
  renderer.entry.sampling.seeds = 2;
  const auto prepared = run::prepare_render(renderer, {}, small_scene(), folder.path() / "render");
  for (const int seed : {1, 2}) EXPECT_TRUE(run::render_once(prepared, {8, seed}, nullptr));
  EXPECT_EQ(read_file(folder.path() / "render/seeds.txt"), "1 4\n2 4\n3 4\n4 4\n");
}

TEST(RenderOnce, EndsWithTheLimitOfTheCase) {
  const TestFolder folder("limit");
  const auto renderer = renderer_in(folder.path(), "sleep 20");
  const auto prepared = run::prepare_render(renderer, {}, small_scene(), folder.path() / "render", 0.2);
  try {
    run::render_once(prepared, {}, nullptr);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("its time limit of 0.2 s"), std::string::npos) << e.what();
  }
}

TEST(RenderOnce, MayRunInASandbox) {
  if (!adapters::why_not_isolated().empty()) GTEST_SKIP() << adapters::why_not_isolated();
  const TestFolder folder("sandbox");
  run::Plan plan;
  plan.suite.references = folder.path() / "references";
  folder.write("references/secret", "s");
  const auto renderer =
      renderer_in(folder.path(), fmt::format("cat {}/references/secret > seen.txt", folder.path().string()));
  for (const bool sandbox : {false, true}) {
    plan.settings.sandbox = sandbox;
    const auto prepared = run::prepare_render(renderer, plan, small_scene(), folder.path() / "study/render");
    EXPECT_TRUE(run::render_once(prepared, {}, nullptr));
    EXPECT_EQ(read_file(folder.path() / "study/render/seen.txt"), sandbox ? "" : "s");
  }
}

TEST(JobFolder, PathsAreNamedWithinIt) {
  EXPECT_EQ(run::named_within("/a/b", "--out=/a/b/c.exr"), "--out=c.exr");
  EXPECT_EQ(run::named_within("/a/b", "/a/b"), ".");
  EXPECT_EQ(run::named_within("/a/v1", "/a/v1.5/c /a/v12 /a/v1-2"), "/a/v1.5/c /a/v12 /a/v1-2");
  EXPECT_EQ(run::named_within("", "/a/b"), "/a/b");
}
