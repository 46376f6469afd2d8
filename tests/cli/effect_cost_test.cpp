// What richer transports cost is for people on a quiet machine; that the images agree, and what is lost
// without an effect, holds on any.
#include "cli/sandbox.h"
#include "image/image_io.h"
#include "json/document.h"
#include "json/object_reader.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::Sandbox;

namespace {

std::vector<std::string> effects_of(const std::string& scenes, const std::string& suite = "appearance") {
  return {"effect-cost", scenes, "--configuration", ORBS_SOURCE_DIR "/configuration.json",
          "--suite",     suite,  "--side",          "32",
          "--spp",       "16",   "--rounds",        "2"};
}

struct Found {
  bool is_equal = false;
  bool is_enough = false;
  double mean = 0;
  std::string bias;
};

std::map<std::string, Found> alternatives_in(const std::string& text) {
  const auto document = json::parse("effect-costs.json", text);
  json::ObjectReader effect_costs(document);
  auto scenes = effect_costs.objects("scenes");
  std::map<std::string, Found> found;
  for (auto& way : scenes.at(0).objects("alternatives"))
    found[way.text("name")] = {way.boolean_or("is_equal", false), way.boolean_or("is_enough", false),
                               way.object("mean_change").number("value"), way.text("bias")};
  return found;
}

}  // namespace

TEST(EffectsCommand, RicherTransportsGiveTheSameImageAndAFilmIsWorthSomething) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs(effects_of("iridescent_spheres_film"));
  ASSERT_EQ(answer.status, 0) << answer.text;
  EXPECT_NE(answer.text.find("iridescent_spheres_film: spectral"), std::string::npos) << answer.text;
  const auto ways = alternatives_in(sandbox.read("effect-costs.json"));
  EXPECT_TRUE(ways.at("bispectral").is_equal);
  EXPECT_TRUE(ways.at("polarised").is_enough);
  EXPECT_EQ(ways.at("polarised").bias, "");
  EXPECT_FALSE(ways.at("rgb").is_enough);
  EXPECT_FALSE(ways.at("without thin film").is_enough);
  EXPECT_GT(std::abs(ways.at("without thin film").mean), 0.01);
}

// The product of two colours is not the colour of the product of two spectra: that is no error.
TEST(EffectsCommand, WavelengthsAreNotEnoughForWhatColouredSurfacesShowInThreeColours) {
  const Sandbox sandbox;
  ASSERT_EQ(sandbox.orbs(effects_of("123-green", "orbs")).status, 0);
  EXPECT_FALSE(alternatives_in(sandbox.read("effect-costs.json")).at("spectral").is_enough);
  const Sandbox grey;
  ASSERT_EQ(grey.orbs(effects_of("l1-oblong", "orbs")).status, 0);
  EXPECT_TRUE(alternatives_in(grey.read("effect-costs.json")).at("spectral").is_enough);
}

TEST(EffectsCommand, ScenesThatMatchNothingAreAnError) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs(effects_of("no_such_scene"));
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.text.find("no_such_scene"), std::string::npos) << answer.text;
  EXPECT_FALSE(sandbox.has("effect-costs.json"));
}

namespace {

// A tiny image of a scene of group E3, out.exr.
cli_tests::Answer render_tiny(const Sandbox& sandbox, const std::string& scene, const std::string& more) {
  return sandbox.shell(ORBS_BINARY_WORD "/orbs-tracer " ORBS_SOURCE_WORD
                                        "/data/cases/appearance/e3_polarisation/" +
                       scene + ".json -o out.exr --spp 4 --width 8 --height 8 " + more);
}

}  // namespace

TEST(TracerTransport, LessThanTheSceneCallsForIsRefusedWithTheReason) {
  const Sandbox sandbox;
  const auto answer = render_tiny(sandbox, "polarizing_plane_0", "--transport rgb");
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.text.find("calls for polarised transport because material 'filter' is a polariser, "
                             "which rgb transport does not have"),
            std::string::npos)
      << answer.text;
  EXPECT_FALSE(sandbox.has("out.exr"));
}

TEST(TracerTransport, LossyAllowsIt) {
  const Sandbox sandbox;
  const auto answer = render_tiny(sandbox, "polarizing_plane_0", "--transport rgb --lossy");
  ASSERT_EQ(answer.status, 0) << answer.text;
  const auto image = image::read_image(sandbox.folder() / "out.exr");
  EXPECT_EQ(image.attributes.at("orbs.transport"), "rgb");
}

TEST(TracerTransport, StokesVectorsComeWithTheirConvention) {
  const Sandbox sandbox;
  const auto answer = render_tiny(sandbox, "polarizing_spheres", "");
  ASSERT_EQ(answer.status, 0) << answer.text;
  const auto image = image::read_image(sandbox.folder() / "out.exr");
  EXPECT_EQ(image.attributes.at("orbs.transport"), "polarised");
  EXPECT_TRUE(image.attributes.contains("orbs.stokes"));
  for (const char* channel : {"S0.R", "S1.G", "S2.B", "S3.R"})
    EXPECT_NE(std::find(image.channels.begin(), image.channels.end(), channel), image.channels.end())
        << channel;
}
