// One image by one command, and what shows it.
#include "cli/sandbox.h"
#include "image/image_io.h"

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::contains;
using cli_tests::Sandbox;

TEST(RenderCommand, WritesOneImage) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"render", "-r", "good", "-s", "grey", "--spp", "16", "-o", "x.exr"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "x.exr: 12 x 8 pixels of grey by good, 16 samples per pixel"))
      << answer.text;
  const auto image = image::read_image(sandbox.folder() / "x.exr");
  EXPECT_EQ(image.width, 12);
  EXPECT_TRUE(sandbox.runs().empty()) << "nothing else is left in the folder";
}

TEST(RenderCommand, SaysWhyThereIsNone) {
  const Sandbox sandbox;
  const auto crash = sandbox.orbs({"render", "-r", "segfault", "-s", "grey", "-o", "x.exr"});
  EXPECT_EQ(crash.status, 1) << crash.text;
  EXPECT_TRUE(contains(crash.text, "segfault made no image of grey: ")) << crash.text;
  EXPECT_FALSE(sandbox.has("x.exr"));
  const auto several = sandbox.orbs({"render", "-r", "good", "-o", "x.exr"});
  EXPECT_EQ(several.status, 2) << several.text;
  EXPECT_TRUE(contains(several.text, "name one with -s")) << several.text;
  const auto both = sandbox.orbs({"render", "-r", "good,dark", "-s", "grey", "-o", "x.exr"});
  EXPECT_TRUE(contains(both.text, "name one with -r")) << both.text;
  const auto png = sandbox.orbs({"render", "-r", "good", "-s", "grey", "-o", "x.png"});
  EXPECT_TRUE(contains(png.text, "expected a name that ends with .exr, not 'x.png'")) << png.text;
}

TEST(OpenCommand, StartsAViewerWithReferenceAndResultOrNamesThem) {
  const Sandbox sandbox;
  const auto before = sandbox.orbs({"open", "grey"});
  EXPECT_EQ(before.status, 2) << before.text;
  sandbox.orbs({"run", "-r", "good,dark", "-s", "grey", "-o", "outputs-1"});
  sandbox.write("viewer", "#!/bin/sh\nprintf 'shows %s\\n' \"$@\"\n");
  sandbox.shell("chmod +x viewer");
  const auto shown = sandbox.orbs({"open", "grey", "-r", "dark", "--viewer", "./viewer"});
  EXPECT_EQ(shown.status, 0) << shown.text;
  const auto reference =
      shown.text.find("shows " + (sandbox.folder() / "outputs-1/references/grey.exr").string());
  const auto result =
      shown.text.find("shows " + (sandbox.folder() / "outputs-1/dark/grey/result.exr").string());
  EXPECT_NE(reference, std::string::npos) << shown.text;
  EXPECT_NE(result, std::string::npos) << shown.text;
  EXPECT_LT(reference, result);
  EXPECT_FALSE(contains(shown.text, "/good/"));
  const auto named = sandbox.orbs({"open", "grey", "--viewer", "no-such-viewer"});
  EXPECT_EQ(named.status, 0) << named.text;
  EXPECT_TRUE(contains(named.text, "outputs-1/good/grey/result.exr")) << named.text;
  EXPECT_TRUE(contains(named.text, "there is no program 'no-such-viewer' here")) << named.text;
  const auto absent = sandbox.orbs({"open", "no-such-scene"});
  EXPECT_EQ(absent.status, 2) << absent.text;
  EXPECT_TRUE(contains(absent.text, "'orbs run -s no-such-scene' makes one")) << absent.text;
}

TEST(CardCommand, AnswersTheThreeQuestionsOfOneRenderer) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "good,dark", "-c", "m1_grey", "-s", "grey", "-o", "outputs-1"});
  const auto card = sandbox.orbs({"card", "dark"});
  EXPECT_EQ(card.status, 0) << card.text;
  EXPECT_TRUE(contains(card.text, "right?")) << card.text;
  EXPECT_TRUE(contains(card.text, "Wrong") || contains(card.text, "wrong in ")) << card.text;
  EXPECT_TRUE(contains(card.text, "not known: orbs cost measures it")) << card.text;
  EXPECT_TRUE(contains(card.text, "not known: orbs stability measures it")) << card.text;
  const auto absent = sandbox.orbs({"card", "nobody"});
  EXPECT_EQ(absent.status, 2) << absent.text;
  EXPECT_TRUE(contains(absent.text, "has a renderer 'nobody'; 'orbs run -r nobody' makes one"))
      << absent.text;
}
