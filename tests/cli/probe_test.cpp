// orbs probe with the built-in tracer, as it is and behind a converter that makes a mistake.
#include "cli/sandbox.h"

#include <regex>

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::Sandbox;

namespace {

// A shell script in place of a renderer: changes the scene by sed and lets the tracer render that.
std::string configuration_with_mistake(const std::string& sed) {
  return R"({ "format": "orbs-configuration/1", "stands_alone": true,
  "suites": [{ "name": "orbs", "cases": ")" ORBS_SOURCE_DIR R"(/data/cases/orbs",
               "references": ")" ORBS_SOURCE_DIR R"(/data/references/orbs" }],
  "renderers": [{ "name": "mistaken", "executable": "/bin/sh", "declares": "G5/M8/L4/A4",
    "command": ["{executable}", "-c", ")" +
         sed + R"( \"$1\" > wrong.json && exec '{build}'/orbs-tracer wrong.json -o \"$2\" --spp 1",
                "converter", "{scene}", "{output}"] }] })";
}

}  // namespace

TEST(ProbeCommand, FindsTheBuiltInTracersScenesWhereTheyShouldBe) {
  const Sandbox sandbox;
  const auto answer =
      sandbox.orbs({"probe", "--configuration", ORBS_SOURCE_DIR "/configuration.json", "-r", "orbs", "-s",
                    "078-remap,113", "--side", "64", "--spp", "4", "-o", "probe.json"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_NE(answer.text.find("all 2 are right"), std::string::npos) << answer.text;
  EXPECT_NE(sandbox.read("probe.json").find("\"ok\": true"), std::string::npos);
}

TEST(ProbeCommand, NamesWhatAWrongCameraMoved) {
  const Sandbox sandbox;
  sandbox.write("configuration.json",
                configuration_with_mistake("sed -E 's/(\\\"fov_y\\\": *)[0-9.]+/\\\\150/'"));
  const auto answer = sandbox.orbs({"probe", "-s", "078", "--side", "64"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_NE(answer.text.find("scene mapping differs: "), std::string::npos) << answer.text;
  EXPECT_NE(answer.text.find("0 of 1 are right, 1 not right"), std::string::npos) << answer.text;
}

// Its converter gets an emissive scene all the same.
TEST(ProbeCommand, AsksNoDeclarationOfEmission) {
  const Sandbox sandbox;
  auto text = configuration_with_mistake("cat");
  text.replace(text.find("G5/M8/L4/A4"), 11, "G5/M1");
  sandbox.write("configuration.json", text);
  const auto answer = sandbox.orbs({"probe", "-s", "101", "--side", "64"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_NE(answer.text.find("texture coordinates not checked: "), std::string::npos) << answer.text;
}

// Textures that reflect show them, too.
TEST(ProbeCommand, ChecksTextureCoordinatesWithoutTexturedEmission) {
  for (const bool are_exchanged : {false, true}) {
    const Sandbox sandbox;
    sandbox.write(
        "exchange.sed",
        are_exchanged ? R"(/"ramp"/,/}/s/"matrix": .*/"matrix": [0,1,0,0, 1,0,0,0, 0,0,1,0, 0,0,0,1]/)" : "");
    auto text = configuration_with_mistake("sed -f " + (sandbox.folder() / "exchange.sed").string());
    text.replace(text.find("G5/M8/L4/A4"), 11, "G5/M5");
    sandbox.write("configuration.json", text);
    const auto answer = sandbox.orbs({"probe", "-s", "113", "--side", "64"});
    EXPECT_EQ(answer.status, are_exchanged ? 1 : 0) << answer.text;
    const std::regex right("ok, [0-9]+ pixels.*, texture coordinates in [1-9][0-9]{2,}");
    EXPECT_EQ(std::regex_search(answer.text, right), !are_exchanged) << answer.text;
    EXPECT_EQ(cli_tests::contains(answer.text, "texture coordinates differ: "), are_exchanged) << answer.text;
  }
}

TEST(ProbeCommand, NothingCheckedIsNothingRight) {
  const Sandbox sandbox;
  auto text = configuration_with_mistake("cat");
  text.replace(text.find("\"declares\""), 0, R"("scene_format": "native", "native_scenes": "own", )");
  sandbox.write("configuration.json", text);
  const auto answer = sandbox.orbs({"probe", "-s", "101", "--side", "64", "-o", "probe.json"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_NE(answer.text.find("0 of 1 are right, 1 not checked"), std::string::npos) << answer.text;
  EXPECT_NE(sandbox.read("probe.json").find("\"checked\": false"), std::string::npos);
}

TEST(ProbeCommand, SaysHowARendererFailed) {
  const Sandbox sandbox;
  sandbox.write("configuration.json", configuration_with_mistake("exit 3; sed"));
  const auto answer = sandbox.orbs({"probe", "-s", "078", "--side", "64"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_NE(answer.text.find("ended with exit code 3"), std::string::npos) << answer.text;
}

TEST(ProbeCommand, ComparesTheLayersThatARendererHas) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"probe", "--configuration", ORBS_SOURCE_DIR "/configuration.json", "-r",
                                    "orbs", "-s", "113", "--side", "64", "--spp", "4"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_NE(answer.text.find("layers depth, position, normal, uv in"), std::string::npos) << answer.text;
}

namespace {

// Of the suite everyday: the tracer itself, one that looks all textures up at the first coordinates, and one
// whose frames have no sign.
std::string configuration_of_everyday() {
  return R"({ "format": "orbs-configuration/1", "stands_alone": true,
  "suites": [{ "name": "everyday", "cases": ")" ORBS_SOURCE_DIR R"(/data/cases/everyday",
               "references": ")" ORBS_SOURCE_DIR R"(/data/references/everyday" }],
  "renderers": [
  { "name": "right", "executable": "{build}/orbs-tracer", "declares": "G5/M8/L4/A4/D6/N6",
    "command": ["{executable}", "{scene}", "-o", "{output}", "--spp", "4"] },
  { "name": "first-alone", "executable": "/bin/sh", "declares": "G5/M8/L4/A4/D6/N6",
    "command": ["{executable}", "-c",
                "sed -E 's/\"uv_set\": *1/\"uv_set\": 0/' \"$1\" > wrong.json && exec '{build}'/orbs-tracer wrong.json -o \"$2\" --spp 4",
                "converter", "{scene}", "{output}"] },
  { "name": "unsigned", "executable": "{build}/orbs-tracer", "declares": "G5/M8/L4/A4/D6/N6",
    "command": ["{executable}", "{scene}", "-o", "{output}", "--spp", "4", "--fault", "frames-without-sign"] }] })";
}

std::string probed(const std::string& renderer, const std::string& scene, int status) {
  const Sandbox sandbox;
  sandbox.write("configuration.json", configuration_of_everyday());
  const auto answer =
      sandbox.orbs({"probe", "--suite", "everyday", "-r", renderer, "-s", scene, "--side", "64"});
  EXPECT_EQ(answer.status, status) << answer.text;
  return answer.text;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST(ProbeCommand, ComparesSecondTextureCoordinates) {
  const auto right = probed("right", "n6-second", 0);
  EXPECT_TRUE(has(right, ", second ones in ")) << right;
  const auto wrong = probed("first-alone", "n6-second", 1);
  EXPECT_TRUE(has(wrong, "second texture coordinates differ: instance 'wall'")) << wrong;
}

TEST(ProbeCommand, ComparesTheFramesOfNormalMaps) {
  const auto right = probed("right", "n1-above", 0);
  EXPECT_TRUE(has(right, ", frames of normal maps in ")) << right;
  const auto wrong = probed("unsigned", "n1-above", 1);
  EXPECT_TRUE(has(wrong, "frames of normal maps differ: ")) << wrong;
  EXPECT_TRUE(has(wrong, "'mirrored'") && has(wrong, "'u mirrored'") && has(wrong, "v the other way"))
      << wrong;
  EXPECT_FALSE(has(wrong, "'plain'")) << wrong;
  EXPECT_FALSE(has(probed("right", "d1-floor", 0), "frames")) << "nothing there follows them";
}
