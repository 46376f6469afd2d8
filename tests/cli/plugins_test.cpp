// Renderers with plug-ins, and scenes with several cameras, as a run handles them.
#include "base/files.h"
#include "cli/sandbox.h"
#include "image/image_io.h"
#include "results/record.h"

#include <filesystem>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::contains;
using cli_tests::replace_in;
using cli_tests::Sandbox;

namespace {

const std::string kPlugins = ORBS_BINARY_DIR "/plugins/";

// One case with the scene "square": the square of the misbehaving plug-in, with this fault.
void write_square(const Sandbox& sandbox, int fault) {
  sandbox.write(
      "cases/m1_grey/square.json",
      fmt::format(
          R"({{"format": "orbs-scene/1", "name": "s", "camera": {{"position": [0, 4, 1], "look_at": [0, 0, 0],
 "width": 12, "height": 8}}, "environment": [1, 1, 1], "materials": [{{"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}}],
 "shapes": [{{"type": "plugin", "plugin": "misbehaving", "numbers": {{"fault": {}}}, "material": "m"}}]}})",
          fault));
}

// In place of all renderers: the built-in tracer with a copy of the plug-in, relative to the configuration.
void write_tracer(const Sandbox& sandbox, const std::string& plugin) {
  std::filesystem::create_directories(sandbox.folder() / "plug-ins");
  std::filesystem::copy_file(kPlugins + plugin + ".so", sandbox.folder() / "plug-ins/misbehaving.so",
                             std::filesystem::copy_options::overwrite_existing);
  sandbox.write("configuration.json",
                R"x({"format": "orbs-configuration/1", "stands_alone": true, "defaults": {"suite": "t"},
"suites": [{"name": "t", "cases": "cases", "references": "references"}],
"renderers": [{"name": "tracer", "executable": "{build}/orbs-tracer", "declares": "G5/M8/S7",
  "plugins": ["plug-ins/misbehaving.so"],
  "command": ["{executable}", "{scene}", "--plugin", "{plugin}", "-o", "{output}", "--spp", "{spp}", "--bad-samples", "count"]
}]
})x");
  replace_in(sandbox, "cases/m1_grey/case.json", R"({"name": "v1.5", "file": "grey.json", "spp": 8})",
             R"({"name": "square", "file": "square.json", "spp": 8, "reference": "grey"})");
}

results::JobRecord job_of(const Sandbox& sandbox) {
  return results::read_job_file(sandbox.folder() / "out/tracer/square/job.json").job;
}

cli_tests::Answer run_square(const Sandbox& sandbox) {
  return sandbox.orbs({"run", "-s", "square", "-o", "out"});
}

}  // namespace

TEST(Plugins, AreGivenToTheRendererByAbsolutePaths) {
  const Sandbox sandbox;
  write_square(sandbox, 0);
  write_tracer(sandbox, "misbehaving");
  const auto answer = sandbox.orbs({"run", "-s", "square", "--dry-run"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "--plugin " + (sandbox.folder() / "plug-ins/misbehaving.so").string()))
      << answer.text;
}

TEST(Plugins, ARebuiltOneRendersAgain) {
  const Sandbox sandbox;
  write_square(sandbox, 0);
  write_tracer(sandbox, "misbehaving");
  run_square(sandbox);
  EXPECT_EQ(job_of(sandbox).end.outcome, results::JobOutcome::Image);
  const auto resume = [&] { return sandbox.orbs({"run", "--resume", "out"}); };
  EXPECT_FALSE(contains(resume().text, "tracer square: its")) << "nothing has changed yet";
  sandbox.shell("echo >> plug-ins/misbehaving.so");
  const auto again = resume();
  EXPECT_TRUE(
      contains(again.text, "tracer square: its program, or a file that its command names, has changed"))
      << again.text;
  EXPECT_FALSE(contains(resume().text, "tracer square: its")) << "rendered with the new one, and again";
}

TEST(Plugins, ThatCrashCrashTheRenderAndNothingElse) {
  const Sandbox sandbox;
  write_square(sandbox, 9);
  write_tracer(sandbox, "misbehaving");
  const auto answer = run_square(sandbox);
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_EQ(job_of(sandbox).end.outcome, results::JobOutcome::Crash);
  EXPECT_TRUE(contains(answer.text, "SIGABRT")) << answer.text;
}

TEST(Plugins, OfAnotherVersionEndTheRenderWithTheReason) {
  const Sandbox sandbox;
  write_square(sandbox, 0);
  write_tracer(sandbox, "other_version");
  const auto answer = run_square(sandbox);
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_TRUE(contains(answer.text, "it is built for version 2 of orbs/shape_plugin.h")) << answer.text;
}

// exit(0) says that all is well. The status and the words are those of the tracer itself.
TEST(Plugins, ThatEndTheProgramFailTheRender) {
  for (const auto& [plugin, fault, words] :
       {std::tuple{"exiting", 0, "the initialiser of plug-in"}, std::tuple{"misbehaving", 13, "a plug-in"}}) {
    const Sandbox sandbox;
    write_square(sandbox, fault);
    write_tracer(sandbox, plugin);
    const auto answer = run_square(sandbox);
    EXPECT_EQ(answer.status, 1) << answer.text;
    EXPECT_EQ(job_of(sandbox).end.outcome, results::JobOutcome::Crash) << answer.text;
    EXPECT_EQ(job_of(sandbox).end.exit_code, 2);
    EXPECT_TRUE(contains(sandbox.read("out/tracer/square/log.txt"), words)) << plugin;
    EXPECT_TRUE(contains(sandbox.read("out/tracer/square/log.txt"), "has called exit()")) << plugin;
  }
}

TEST(Plugins, ThatBreakTheirRulesAreCountedInTheImage) {
  const Sandbox sandbox;
  write_square(sandbox, 1);
  write_tracer(sandbox, "misbehaving");
  run_square(sandbox);
  ASSERT_EQ(job_of(sandbox).end.outcome, results::JobOutcome::Image);
  const auto image = image::read_image(sandbox.folder() / "out/tracer/square/result.exr");
  EXPECT_GT(std::stoi(image.attributes.at("orbs.plugin_faults")), 0);
  EXPECT_TRUE(contains(sandbox.read("out/tracer/square/log.txt"), "warning: plug-ins broke their rules"))
      << sandbox.read("out/tracer/square/log.txt");
  // Misses: the sky shows through.
  EXPECT_EQ(image.at(6, 4, 0), 1);
}

TEST(Plugins, OfAnEntryNeedAWordOfItsCommand) {
  const Sandbox sandbox;
  write_square(sandbox, 0);
  write_tracer(sandbox, "misbehaving");
  replace_in(sandbox, "configuration.json", R"("--plugin", "{plugin}", )", "");
  const auto answer = sandbox.orbs({"run", "--dry-run"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "/renderers/0/plugins: needs a word with {plugin} in the command"))
      << answer.text;
}

// The renderer gets a scene with the chosen camera alone, so {width} and {height} are those of the camera.
TEST(Cameras, OfOneFileAreTargetsOfTheirOwn) {
  const Sandbox sandbox;
  replace_in(
      sandbox, "cases/m1_grey/grey.json", R"("materials")",
      R"("cameras": {"wide": {"position": [0, 4, 1], "look_at": [0, 0, 0], "width": 24, "height": 8}}, "materials")");
  replace_in(sandbox, "cases/m1_grey/case.json", R"({"name": "v1.5", "file": "grey.json", "spp": 8})",
             R"({"name": "v1.5", "file": "grey.json", "camera": "wide", "spp": 8})");
  const auto answer = sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-o", "out"});
  const auto grey = image::read_image(sandbox.folder() / "out/good/grey/result.exr");
  const auto wide = image::read_image(sandbox.folder() / "out/good/v1.5/result.exr");
  EXPECT_EQ(grey.width, 12) << answer.text;
  EXPECT_EQ(wide.width, 24) << answer.text;
  EXPECT_FALSE(contains(sandbox.read("out/good/v1.5/scene.json"), "cameras"));
  replace_in(sandbox, "cases/m1_grey/case.json", R"("camera": "wide")", R"("camera": "wild")");
  const auto unknown = sandbox.orbs({"run", "-r", "good"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(contains(unknown.text, "there is no camera 'wild' (did you mean 'wide'?); there are: wide"))
      << unknown.text;
}
