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

}  // namespace

TEST(Export, WhatIsRenderedElsewhereGetsTheSameVerdictsAsThroughTheAdapter) {
  const Sandbox sandbox;
  for (const char* renderer : {"good", "noisy", "dark"}) {
    const std::string name = renderer;
    const auto exported = sandbox.orbs({"export", "--format", "orbs", "-r", name, "-o", "for-" + name});
    EXPECT_EQ(exported.status, 0) << exported.text;
    EXPECT_TRUE(contains(exported.text, "3 renders written to")) << exported.text;
    EXPECT_EQ(
        sandbox.shell("mv for-" + name + " elsewhere-" + name + " && sh elsewhere-" + name + "/render.sh")
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

TEST(Export, AVariableOfTheEnvironmentMayHoldBlanks) {
  const Sandbox sandbox;
  sandbox.add_to_good(R"(, "environment": ["OPTIONS=slow and sure"])");
  sandbox.orbs({"export", "--format", "orbs", "-r", "good", "-s", "grey", "-o", "out"});
  const auto script = sandbox.shell("sh out/render.sh");
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
