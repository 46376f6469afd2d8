// Scenes exported for a renderer that is elsewhere, rendered by hand in another folder, and judged.
#include "cli/sandbox.h"

#include <regex>

#include <gtest/gtest.h>

using orbs::cli_tests::contains;
using orbs::cli_tests::replace_in;
using orbs::cli_tests::Sandbox;

namespace {

// Everything that is said of the targets: verdict, reasons, numbers.
std::string verdicts(const Sandbox& sandbox, const std::string& folder) {
  const auto text = sandbox.read(folder + "/results.json");
  const auto begin = text.find("\n  \"targets\": [");
  return text.substr(begin, text.find("\n  \"jobs\": [") - begin);
}

// The other machine says which program it is.
const std::string kProgram = "RENDERER=" ORBS_BINARY_WORD "/orbs-fake-renderer ";

}  // namespace

TEST(Export, WhatIsRenderedElsewhereGetsTheSameVerdictsAsThroughTheAdapter) {
  const Sandbox sandbox;
  for (const char* renderer : {"good", "noisy", "dark"}) {
    const std::string name = renderer;
    const auto exported = sandbox.orbs({"export", "--format", "orbs", "-r", name, "-o", "for-" + name});
    EXPECT_EQ(exported.status, 0) << exported.text;
    EXPECT_TRUE(contains(exported.text, "3 renders written to")) << exported.text;
    EXPECT_EQ(sandbox
                  .shell("mv for-" + name + " elsewhere-" + name + " && " + kProgram + "sh elsewhere-" +
                         name + "/render.sh")
                  .status,
              0);
    const auto judged = sandbox.orbs({"judge", "elsewhere-" + name, "-o", "judged-" + name});
    const auto local = sandbox.orbs({"run", "-r", name, "-o", "local-" + name});
    EXPECT_EQ(judged.status, local.status) << judged.text;
    EXPECT_EQ(verdicts(sandbox, "judged-" + name), verdicts(sandbox, "local-" + name));
  }
}

TEST(Export, ASceneMayHaveItsOwnSettings) {
  const Sandbox sandbox;
  sandbox.add_to_good(R"(, "scene_format": "povray", "scene_settings": {"radiosity_count": 55},)"
                      R"( "scene_settings_of_scenes": {"mirror": {"radiosity_count": 77}})");
  const auto exported = sandbox.orbs({"export", "--format", "povray", "-r", "good", "-o", "out"});
  EXPECT_EQ(exported.status, 0) << exported.text;
  EXPECT_TRUE(contains(sandbox.read("out/good/mirror/scene.pov"), "count 77"));
  EXPECT_TRUE(contains(sandbox.read("out/good/grey/scene.pov"), "count 55"));
}

TEST(Export, AnImageThatDidNotComeBackIsNoOutput) {
  const Sandbox sandbox;
  sandbox.orbs({"export", "--format", "orbs", "-r", "good", "-s", "grey", "-o", "out"});
  const auto judged = sandbox.orbs({"judge", "out"});
  EXPECT_EQ(judged.status, 1);
  EXPECT_TRUE(contains(judged.text, "no output")) << judged.text;
}

TEST(Export, ARendererThatIsNotInstalledIsExportedForAllTheSame) {
  const Sandbox sandbox;
  replace_in(sandbox, "configuration.json",
             "\"name\": \"good\", \"executable\": \"{build}/orbs-fake-renderer\"",
             "\"name\": \"good\", \"executable\": \"not-here\"");
  EXPECT_EQ(sandbox.orbs({"run", "-r", "good"}).status, 2);
  EXPECT_EQ(sandbox.orbs({"export", "--format", "orbs", "-r", "good", "-o", "out"}).status, 0);
  const auto script = sandbox.read("out/render.sh");
  EXPECT_TRUE(contains(script, "renderer=${RENDERER:-not-here}\n")) << script;
  EXPECT_TRUE(
      contains(script, "(cd good/grey && \"$renderer\" --mode good --output result.exr --scene scene.json"))
      << script;
  EXPECT_FALSE(contains(script, sandbox.folder().string())) << script;
}

// Scripts and plug-ins come along, with what the scripts import.
TEST(Export, NamesNoFolderOfThisMachine) {
  const Sandbox sandbox;
  sandbox.write("adapter/start.sh", "#!/bin/sh\n. \"$(dirname \"$0\")/more.sh\"\n");
  sandbox.write("adapter/more.sh", "shift\nexec \"$@\"\n");
  sandbox.write("adapter/notes.txt", "not of the program");
  replace_in(sandbox, "configuration.json", R"("command": ["{executable}", "--mode", "good")",
             R"("command": ["sh", "{root}/adapter/start.sh", "--", "{executable}", "--mode", "good")");
  const auto exported = sandbox.orbs({"export", "--format", "orbs", "-r", "good", "-s", "grey", "-o", "out"});
  ASSERT_EQ(exported.status, 0) << exported.text;
  const auto found =
      sandbox.shell("grep -rlF -e " + sandbox.folder().string() + " -e " ORBS_BINARY_WORD " out");
  EXPECT_EQ(found.text, "") << sandbox.read("out/render.sh");
  EXPECT_TRUE(sandbox.has("out/programs/good/more.sh"));
  EXPECT_EQ(sandbox.shell("ls out/programs/good").text, "more.sh\nstart.sh\n");
  EXPECT_EQ(sandbox.shell("mv adapter gone; " + kProgram + "sh out/render.sh").status, 0);
  EXPECT_TRUE(sandbox.has("out/good/grey/result.exr"));
}

TEST(Export, ListsTheImagesForProgramsThatReadNoScript) {
  const Sandbox sandbox;
  sandbox.orbs({"export", "--format", "orbs", "-r", "good", "-s", "grey", "--seed", "3", "-o", "out"});
  EXPECT_EQ(sandbox.read("out/export.json"), R"({
  "format": "orbs-export/1",
  "suite": "t",
  "size": "1",
  "image_format": "OpenEXR with the channels R, G and B, 32-bit float: linear Rec.709 radiance without a tone curve, not denoised; each pixel is the mean over its square. In place of an .exr that is not there, a .pfm or .hdr of the same name is taken",
  "images": [
    {
      "image": "good/grey/result.exr",
      "scene_file": "good/grey/scene.json",
      "scene": "grey",
      "renderer": "good",
      "width_px": 12,
      "height_px": 8,
      "spp": 8,
      "seed": 3,
      "trace_depth": 5,
      "time_limit_seconds": 60,
      "files": ["good/grey/scene.0.ply", "good/grey/scene.json"]
    }
  ]
}
)");
}

// The folder may come back to a machine that has the suite somewhere else.
TEST(Export, IsJudgedWhereverTheSuiteIs) {
  const Sandbox sandbox;
  sandbox.shell("mkdir here there && mv cases references configuration.json here");
  const auto exported =
      sandbox.shell("cd here && " ORBS_BINARY_WORD "/orbs export --format orbs -r good -s grey -o ../out");
  ASSERT_EQ(exported.status, 0) << exported.text;
  sandbox.shell("mv here there/suite && " + kProgram + "sh out/render.sh");
  const auto judged =
      sandbox.shell("cd there/suite && " ORBS_BINARY_WORD "/orbs judge ../../out -o ../../judged");
  EXPECT_EQ(judged.status, 0) << judged.text;
}

TEST(Export, AVariableOfTheEnvironmentMayHoldBlanks) {
  const Sandbox sandbox;
  sandbox.add_to_good(R"(, "environment": ["OPTIONS=slow and sure"])");
  sandbox.orbs({"export", "--format", "orbs", "-r", "good", "-s", "grey", "-o", "out"});
  const auto script = sandbox.shell(kProgram + "sh out/render.sh");
  EXPECT_EQ(script.status, 0) << script.text;
  EXPECT_TRUE(sandbox.has("out/good/grey/result.exr")) << script.text;
}

TEST(Export, AFormatThatTheRendererDoesNotReadIsRefused) {
  const Sandbox sandbox;
  EXPECT_EQ(sandbox.orbs({"export", "--format", "pbrt"}).status, 2);
  const auto other = sandbox.orbs({"export", "--format", "pbrt", "-r", "good"});
  EXPECT_EQ(other.status, 2);
  EXPECT_TRUE(contains(other.text, "reads orbs-scene, not pbrt")) << other.text;
}
