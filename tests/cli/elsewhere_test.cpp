// Renderers that are elsewhere and read meshes: exported, rendered by somebody who has only the folder, and
// judged.
#include "cli/sandbox.h"
#include "image/image_io.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

using orbs::cli_tests::Answer;
using orbs::cli_tests::contains;
using orbs::cli_tests::Sandbox;

namespace {

const std::string kShipped = ORBS_SOURCE_DIR "/configuration.json";
// Who renders has a program of his own, which reads the description and the meshes.
const std::string kRenderer =
    "chmod +x render-there; ORBS_TRACER=" ORBS_BINARY_WORD "/orbs-tracer RENDERER=$PWD/render-there ";

Answer judged_elsewhere(const Sandbox& sandbox, const std::string& renderer, const std::string& scenes) {
  sandbox.write("render-there", "#!/bin/sh\nexec /usr/bin/python3 " ORBS_SOURCE_WORD
                                "/tests/cli/description_renderer.py \"$@\"\n");
  const auto exported = sandbox.orbs({"export", "--configuration", kShipped, "-r", renderer, "-s", scenes,
                                      "--size", "1/8", "--spp-scale", "2", "-o", "out"});
  EXPECT_EQ(exported.status, 0) << exported.text;
  EXPECT_TRUE(contains(exported.text, "render the images that ")) << exported.text;
  const auto rendered = sandbox.shell("mv out there; " + kRenderer + "sh there/render.sh");
  EXPECT_EQ(rendered.status, 0) << rendered.text;
  return sandbox.orbs({"judge", "--configuration", kShipped, "there", "-o", "judged"});
}

}  // namespace

// Camera, lamps by matrices, textures with matrices, remap lists: nothing that makes the image is left out.
TEST(Elsewhere, TheDescriptionAndTheMeshesSayAllThatMakesTheImage) {
  for (const std::string renderer : {"obj", "ply"}) {
    const Sandbox sandbox;
    const auto answer = judged_elsewhere(sandbox, renderer, "g2-camera-wide,103,g3-matrices");
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_TRUE(contains(answer.text, " 3 pass ")) << answer.text;
  }
}

TEST(Elsewhere, ARunLeavesItOutUnlessItIsNamed) {
  const Sandbox sandbox;
  sandbox.add_to_good(R"(, "elsewhere": true)");
  const auto named = sandbox.orbs({"run", "-r", "good", "-o", "out"});
  EXPECT_EQ(named.status, 2);
  EXPECT_TRUE(contains(named.text, "renderer 'good' is elsewhere")) << named.text;
  EXPECT_TRUE(contains(named.text, "orbs export -r good")) << named.text;
  const auto matched = sandbox.orbs({"run", "-r", "goo*,noisy", "-s", "grey", "-o", "out"});
  EXPECT_FALSE(contains(matched.text, "good")) << matched.text;
  const auto here = sandbox.orbs(
      {"run", "-r", "good", "-e", ORBS_BINARY_DIR "/orbs-fake-renderer", "-s", "grey", "-o", "here"});
  EXPECT_EQ(here.status, 0) << here.text;
  EXPECT_TRUE(contains(sandbox.orbs({"doctor", "--configuration", kShipped, "-r", "obj"}).text,
                       "it is elsewhere, for orbs export and orbs judge"));
}

TEST(Elsewhere, ItsScriptAsksForTheProgram) {
  const Sandbox sandbox;
  sandbox.add_to_good(R"(, "elsewhere": true)");
  sandbox.orbs({"export", "-r", "good", "-s", "grey", "-o", "out"});
  const auto without = sandbox.shell("unset RENDERER; sh out/render.sh");
  EXPECT_NE(without.status, 0);
  EXPECT_TRUE(contains(without.text, "RENDERER: is not set: the program that renders")) << without.text;
  EXPECT_EQ(sandbox.shell("RENDERER=" ORBS_BINARY_WORD "/orbs-fake-renderer sh out/render.sh").status, 0);
  EXPECT_EQ(sandbox.orbs({"judge", "out", "-o", "judged"}).status, 0);
}

// PFM: rows from the bottom, floats of little endian.
TEST(Elsewhere, AnImageMayComeBackAsPfm) {
  const Sandbox sandbox;
  sandbox.orbs({"export", "-r", "good", "-s", "grey", "-o", "out"});
  sandbox.shell("RENDERER=" ORBS_BINARY_WORD "/orbs-fake-renderer sh out/render.sh");
  const auto exr = sandbox.folder() / "out/good/grey/result.exr";
  const auto image = orbs::image::read_image(exr);
  std::filesystem::remove(exr);
  std::string pfm = "PF\n12 8\n-1.0\n";
  for (int y = 7; y >= 0; --y)
    for (int x = 0; x < 12; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const float value = image.at(x, y, c);
        pfm.append(reinterpret_cast<const char*>(&value), sizeof value);
      }
  sandbox.write("out/good/grey/result.pfm", pfm);
  const auto judged = sandbox.orbs({"judge", "out", "-o", "judged"});
  EXPECT_EQ(judged.status, 0) << judged.text;
  EXPECT_EQ(orbs::image::read_image(sandbox.folder() / "judged/good/grey/result.exr").pixels, image.pixels);
  sandbox.write("out/good/grey/result.pfm", pfm.substr(0, 40));
  const auto torn = sandbox.orbs({"judge", "out", "-o", "torn"});
  EXPECT_EQ(torn.status, 1) << torn.text;
  EXPECT_TRUE(contains(torn.text, "unreadable")) << torn.text;
}

TEST(Elsewhere, AnExportNeedsAFormatOrARenderer) {
  const Sandbox sandbox;
  const auto neither = sandbox.orbs({"export", "-o", "out"});
  EXPECT_EQ(neither.status, 2);
  EXPECT_TRUE(contains(neither.text, "expected a renderer (-r NAME) or a --format")) << neither.text;
  EXPECT_EQ(sandbox.orbs({"export", "-r", "good", "-s", "grey", "-o", "out"}).status, 0);
  EXPECT_TRUE(sandbox.has("out/good/grey/scene.json"));
}
