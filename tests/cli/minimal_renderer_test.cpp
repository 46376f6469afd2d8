// The renderer that people copy: right as it is, and with each of its bugs wrong in the way that orbs says.
#include "cli/sandbox.h"

#include <regex>
#include <string>

#include <gtest/gtest.h>

using orbs::cli_tests::Answer;
using orbs::cli_tests::contains;
using orbs::cli_tests::Sandbox;

namespace {

const std::string kFolder = ORBS_BINARY_DIR "/minimal-renderer/";
const std::string kProgram = ORBS_BINARY_WORD "/minimal-renderer/minimal-renderer";  // as a word of the shell

Answer run(const Sandbox& sandbox, const std::string& renderer, const std::string& scenes) {
  return sandbox.orbs({"run", "--configuration", kFolder + "bugs.json", "-r", renderer, "-s", scenes,
                       "--size", "1/8", "-v", "-o", "out"});
}

void expect_named(const std::string& bug, const std::string& scene, const std::string& words) {
  const Sandbox sandbox;
  const auto answer = run(sandbox, "minimal-" + bug, scene);
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_TRUE(std::regex_search(answer.text, std::regex("\nfail .*" + words))) << answer.text;
}

}  // namespace

// At 1/8, a lamp's light alone, textures and a camera: each is certain within seconds.
TEST(MinimalRenderer, IsRight) {
  const Sandbox sandbox;
  const auto answer = run(sandbox, "minimal-right", "101-depth1,103,g2-camera-wide");
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, " 3 pass ")) << answer.text;
}

// Emission, a mirror and a disk have right answers by a formula; their paths have no limit.
TEST(MinimalRenderer, FindsTheAnswersOfFormulas) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs(
      {"run", "--configuration", kFolder + "configuration.json", "-r", "minimal", "--suite", "known", "-s",
       "flat-field,furnace-plane,glowing-panel,mirror-ball,disk-above", "-o", "out"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, " 4 pass ")) << answer.text;  // M1, M2, M3 and L1
}

TEST(MinimalRenderer, PlacesGeometryAndTextures) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"probe", "--configuration", kFolder + "configuration.json", "-r",
                                    "minimal", "-s", "g1-attributes,g2-camera-wide", "--side", "64"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "all 2 are right")) << answer.text;
}

TEST(MinimalRenderer, RaysThroughTheCornersOfPixelsAreNamed) {
  expect_named("half-pixel", "101", "shifted by \\(0.5, 0.5\\) px");
}

TEST(MinimalRenderer, AnEncodedImageIsNamed) {
  expect_named("gamma", "101", "encoded for the screen \\(sRGB\\), not linear");
}

TEST(MinimalRenderer, LightThatIsCountedTwiceIsNamed) { expect_named("mis", "101", "no MIS weight"); }

TEST(MinimalRenderer, RefusesWhatItDoesNotKnow) {
  const Sandbox sandbox;
  const auto exported =
      sandbox.orbs({"export", "--format", "orbs", "--configuration", kFolder + "configuration.json", "-r",
                    "minimal", "-s", "101", "--size", "1/8", "-o", "out"});
  ASSERT_EQ(exported.status, 0) << exported.text;
  const auto render = [&](const std::string& change, const std::string& rest) {
    return sandbox.shell("cd out/minimal/101 && sed '" + change + "' scene.json > changed.json && " +
                         kProgram + " changed.json a.exr --spp 1 " + rest);
  };
  EXPECT_EQ(render("", "").status, 0);
  EXPECT_TRUE(
      contains(render("s/\"lambert\"/\"glass\"/", "").text, "a material of the type glass is not known"));
  EXPECT_TRUE(contains(render("s/\"look_at\"/\"lens\": 1, &/", "").text, "/camera/lens is not known"));
  EXPECT_TRUE(contains(render("s/\"fov_y\": *[0-9]*/\"fov_y\": \"wide\"/", "").text,
                       "/camera/fov_y is wide, and a number was expected"));
  EXPECT_EQ(render("", "--denoise 1").status, 1);
  EXPECT_EQ(render("", "--bug colour").status, 1);
}

TEST(MinimalRenderer, DrawsTheSameImageWithAnyNumberOfThreads) {
  const Sandbox sandbox;
  sandbox.orbs({"export", "--format", "orbs", "--configuration", kFolder + "configuration.json", "-r",
                "minimal", "-s", "101", "--size", "1/8", "-o", "out"});
  const auto answer = sandbox.shell("cd out/minimal/101 && for n in 1 3; do " + kProgram +
                                    " scene.json $n.exr --spp 2 --threads $n; done; cmp 1.exr 3.exr");
  EXPECT_EQ(answer.status, 0) << answer.text;
}
