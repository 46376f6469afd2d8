// The algorithms that orbs-tracer can be told to use, and the renderers of data/bench/algorithms.json.
#include "image/image_io.h"
#include "registry/configuration.h"
#include "registry/placeholders.h"
#include "sandbox.h"

#include <map>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using cli_tests::Sandbox;

const std::string kScene = ORBS_SOURCE_DIR "/data/bench/veach-plates.json";

cli_tests::Answer render_tiny(const Sandbox& sandbox, const std::string& more) {
  return sandbox.shell(ORBS_BINARY_DIR "/orbs-tracer " + kScene +
                       " -o out.exr --spp 4 --width 8 --height 6 " + more);
}

}  // namespace

TEST(TracerAlgorithms, MoreReplicatesThanSamplesAreRefused) {
  const Sandbox sandbox;
  const auto answer = render_tiny(sandbox, "--replicates 8");
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.text.find("--replicates 8 need as many samples, and --spp is 4"), std::string::npos)
      << answer.text;
  EXPECT_EQ(render_tiny(sandbox, "--replicates 4").status, 0);
}

TEST(TracerAlgorithms, UnknownNamesAreRefused) {
  const Sandbox sandbox;
  EXPECT_EQ(render_tiny(sandbox, "--sampler halton").status, 2);
  EXPECT_EQ(render_tiny(sandbox, "--direct-light both").status, 2);
}

// The header of the image says what each has used.
TEST(TracerAlgorithms, EachRendererOfTheConfigurationUsesItsOwn) {
  const Sandbox sandbox;
  const auto configuration = registry::load_configuration(ORBS_SOURCE_DIR "/data/bench/algorithms.json");
  const registry::Placeholders values{{"executable", ORBS_BINARY_DIR "/orbs-tracer"},
                                      {"scene", kScene},
                                      {"output", "out.exr"},
                                      {"spp", "4"},
                                      {"seed", "1"},
                                      {"threads", "1"}};
  std::map<std::string, std::map<std::string, std::string>> headers;
  for (const auto& renderer : configuration.renderers) {
    std::string line;
    for (const auto& word : registry::fill_placeholders(renderer.command.words, values)) line += word + " ";
    const auto answer = sandbox.shell(line + "--width 8 --height 6");
    ASSERT_EQ(answer.status, 0) << renderer.name << ": " << answer.text;
    headers[renderer.name] = image::read_image(sandbox.folder() / "out.exr").attributes;
  }
  EXPECT_EQ(headers.size(), 11U);
  EXPECT_EQ(headers["orbs-independent"]["orbs.sampler"], "independent");
  EXPECT_EQ(headers["orbs-stratified"]["orbs.sampler"], "stratified");
  EXPECT_EQ(headers["orbs-sobol-1"]["orbs.replicates"], "1");
  EXPECT_EQ(headers["orbs-sobol-4"]["orbs.replicates"], "4");
  EXPECT_EQ(headers["orbs-bsdf-only"]["orbs.direct_light"], "bsdf");
  EXPECT_EQ(headers["orbs-light-only"]["orbs.direct_light"], "light");
  EXPECT_EQ(headers["orbs-no-roulette"]["orbs.roulette"], "no");
  EXPECT_EQ(headers["orbs-no-light-paths"]["orbs.light_paths"], "no");
  EXPECT_EQ(headers["orbs-selection-by-power"]["orbs.light_selection"], "power");
  EXPECT_EQ(headers["orbs-light-connections"]["orbs.light_connections"], "yes");
  EXPECT_EQ(headers["orbs-no-mirrored-light"]["orbs.mirrored_light"], "no");
}

// A trial takes 65,536 camera paths, which an image of few does not win back.
TEST(TracerAlgorithms, AnImageOfFewPathsIsNotWorthATrial) {
  const Sandbox sandbox;
  const auto selection_at = [&](int width_px) {
    const auto answer =
        sandbox.shell(ORBS_BINARY_DIR "/orbs-tracer " + kScene +
                      " -o out.exr --spp 1 --replicates 1 --height 64 --width " + std::to_string(width_px));
    EXPECT_EQ(answer.status, 0) << answer.text;
    return image::read_image(sandbox.folder() / "out.exr").attributes["orbs.light_selection"];
  };
  EXPECT_EQ(selection_at(64), "bvh");
  EXPECT_EQ(selection_at(63), "power");
}

// Each takes at least as many samples as independent blocks, also where only the fixed cost is measured.
TEST(TracerAlgorithms, TheirCostCanBeMeasured) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"cost", "--configuration", ORBS_SOURCE_DIR "/data/bench/algorithms.json",
                                    "-s", "g4-lambert", "-r", "orbs-sobol-4", "--size", "1/8", "--sweep", "8",
                                    "--seeds", "2", "--threads", "1", "--time", "10s", "-o", "study"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_EQ(answer.text.find("need as many samples"), std::string::npos) << answer.text;
  EXPECT_TRUE(sandbox.has("study/images/orbs-sobol-4/g4-lambert/0.exr")) << answer.text;
}
