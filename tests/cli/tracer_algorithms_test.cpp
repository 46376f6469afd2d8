// The algorithms that orbs-tracer can be told to use, and the renderers of data/bench/algorithms.json.
#include "base/text.h"
#include "image/image_io.h"
#include "registry/configuration.h"
#include "registry/placeholders.h"
#include "sandbox.h"

#include <map>
#include <utility>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using cli_tests::Sandbox;

const std::string kScene = ORBS_SOURCE_DIR "/data/bench/veach-plates.json";
const std::string kSceneWord = ORBS_SOURCE_WORD "/data/bench/veach-plates.json";

cli_tests::Answer render_tiny(const Sandbox& sandbox, const std::string& more) {
  return sandbox.shell(ORBS_BINARY_WORD "/orbs-tracer " + kSceneWord +
                       " -o out.exr --spp 4 --width 8 --height 6 " + more);
}

}  // namespace

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
  std::map<std::string, bool> has_variances;
  for (const auto& renderer : configuration.renderers) {
    auto words = registry::fill_placeholders(renderer.command.words, values);
    words.insert(words.end(), {"--width", "8", "--height", "6"});
    const auto answer = sandbox.shell(shell_text(words));
    ASSERT_EQ(answer.status, 0) << renderer.name << ": " << answer.text;
    auto image = image::read_image(sandbox.folder() / "out.exr");
    has_variances[renderer.name] = image.channels.size() > 3;
    headers[renderer.name] = std::move(image.attributes);
  }
  EXPECT_EQ(headers.size(), 11U);
  EXPECT_TRUE(has_variances["orbs-sobol"]);
  EXPECT_FALSE(has_variances["orbs-no-variances"]);
  EXPECT_EQ(headers["orbs-independent"]["orbs.sampler"], "independent");
  EXPECT_EQ(headers["orbs-stratified"]["orbs.sampler"], "stratified");
  EXPECT_EQ(headers["orbs-sobol"]["orbs.sampler"], "sobol");
  EXPECT_EQ(headers["orbs-bsdf-only"]["orbs.direct_light"], "bsdf");
  EXPECT_EQ(headers["orbs-light-only"]["orbs.direct_light"], "light");
  EXPECT_EQ(headers["orbs-no-roulette"]["orbs.roulette"], "no");
  EXPECT_EQ(headers["orbs-no-light-paths"]["orbs.light_paths"], "no");
  EXPECT_EQ(headers["orbs-selection-by-power"]["orbs.light_selection"], "power");
  EXPECT_EQ(headers["orbs-light-connections"]["orbs.light_connections"], "yes");
  EXPECT_EQ(headers["orbs-no-mirrored-light"]["orbs.mirrored_light"], "no");
}

// Each fault changes the scenes that it is about, and the image says which it is.
TEST(TracerFaults, ChangeTheImageAndAreNamedInIt) {
  const Sandbox sandbox;
  const auto rendered = [&](const std::string& scene, const std::string& fault) {
    const auto answer =
        sandbox.shell(ORBS_BINARY_WORD "/orbs-tracer " ORBS_SOURCE_WORD "/data/cases/orbs/" + scene +
                      " -o out.exr --spp 16 --width 24 --height 24 --light-paths never" +
                      (fault.empty() ? "" : " --fault " + fault));
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_EQ(answer.text.find("changes nothing"), std::string::npos) << answer.text;
    auto image = image::read_image(sandbox.folder() / "out.exr");
    EXPECT_EQ(image.attributes["orbs.fault"], fault);
    return image;
  };
  const auto mean = [](const image::Image& image) {
    double sum = 0;
    for (const float value : image::select_rgb(image, "").pixels) sum += static_cast<double>(value);
    return sum / static_cast<double>(3 * image.pixel_count());
  };
  const std::string depth_2 = "a1_trace_depth/101-depth2.json";
  EXPECT_TRUE(image::has_same_colours(rendered(depth_2, "one-bounce-less"),
                                      rendered("a1_trace_depth/101-depth1.json", "")));
  const auto right = rendered(depth_2, "");
  EXPECT_LT(mean(rendered(depth_2, "emitters-only")), mean(right));
  EXPECT_GT(mean(rendered(depth_2, "no-mis-weight")), 1.2 * mean(right));
  EXPECT_GT(mean(rendered("m4_lambert_texture/103.json", "raw-textures")),
            1.05 * mean(rendered("m4_lambert_texture/103.json", "")));
  const std::string matrices = "g3_inst_matrices/g3-matrices.json";
  EXPECT_FALSE(image::has_same_colours(rendered(matrices, "normals-by-matrix"), rendered(matrices, "")));
  const auto nothing =
      sandbox.shell(ORBS_BINARY_WORD "/orbs-tracer " ORBS_SOURCE_WORD "/data/cases/orbs/" + depth_2 +
                    " -o out.exr --spp 4 --width 8 --height 8 --fault raw-textures");
  EXPECT_NE(nothing.text.find("warning: --fault raw-textures changes nothing"), std::string::npos)
      << nothing.text;
}

// A setting that a scene does not allow is said, in the terminal and in the image.
TEST(TracerAlgorithms, AlwaysWhereItCannotBeIsSaid) {
  const Sandbox sandbox;
  const auto said_of = [&](const std::string& scene, const std::string& more) {
    const auto answer = sandbox.shell(ORBS_BINARY_WORD "/orbs-tracer " ORBS_SOURCE_WORD "/data/cases/" +
                                      scene + " -o out.exr --spp 4 --width 8 --height 6 " + more);
    EXPECT_EQ(answer.status, 0) << answer.text;
    const auto attributes = image::read_image(sandbox.folder() / "out.exr").attributes;
    const auto ignored = attributes.find("orbs.ignored_options");
    if (ignored == attributes.end()) return std::string();
    EXPECT_NE(answer.text.find("warning: " + ignored->second.substr(0, 30)), std::string::npos)
        << answer.text;
    return ignored->second;
  };
  const std::string polarised = "appearance/e3_polarisation/polarizing_plane_0.json";
  EXPECT_EQ(said_of(polarised, "--light-paths always").substr(0, 64),
            "--light-paths always has no effect: they carry no polarisation, ");
  EXPECT_NE(said_of(polarised, "--light-connections always --light-paths always").find("--light-connections"),
            std::string::npos);
  EXPECT_EQ(said_of(polarised, ""), "");
  EXPECT_EQ(said_of("orbs/a1_trace_depth/101-depth2.json", "--light-paths always"), "");
}

// The trials may have 7 % of the paths, of which a decision needs some hundreds.
TEST(TracerAlgorithms, AnImageOfFewPathsIsNotWorthATrial) {
  const Sandbox sandbox;
  const auto selection_at = [&](int width_px) {
    const auto answer = sandbox.shell(ORBS_BINARY_WORD "/orbs-tracer " + kSceneWord +
                                      " -o out.exr --spp 1 --height 64 --width " + std::to_string(width_px));
    EXPECT_EQ(answer.status, 0) << answer.text;
    return image::read_image(sandbox.folder() / "out.exr").attributes["orbs.light_selection"];
  };
  EXPECT_EQ(selection_at(256), "bvh");
  EXPECT_EQ(selection_at(64), "power");
}

// Also where only the fixed cost is measured.
TEST(TracerAlgorithms, TheirCostCanBeMeasured) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"cost", "--configuration", ORBS_SOURCE_DIR "/data/bench/algorithms.json",
                                    "-s", "g4-lambert", "-r", "orbs-sobol", "--size", "1/8", "--sweep", "8",
                                    "--seeds", "2", "--threads", "1", "--time", "10s", "-o", "study"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(sandbox.has("study/images/orbs-sobol/g4-lambert/0.exr")) << answer.text;
}
