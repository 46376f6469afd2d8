#include "cli/sandbox.h"
#include "image/image_io.h"
#include "json/document.h"
#include "json/object_reader.h"

#include <algorithm>
#include <limits>
#include <regex>

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::contains;
using cli_tests::Sandbox;

namespace {

void write_grey(
    const Sandbox& sandbox, const std::string& file, float value, int width = 16, int height = 12) {
  auto image = image::make_image(width, height, {"R", "G", "B"});
  for (auto& sample : image.pixels) sample = value;
  image::write_exr(image, sandbox.folder() / file);
}

}  // namespace

TEST(List, ShowsWhatCanBeChosen) {
  const Sandbox sandbox;
  EXPECT_TRUE(contains(sandbox.orbs({"list", "scenes"}).text, "v1.5"));
  EXPECT_TRUE(contains(sandbox.orbs({"list", "scenes"}).text, "mirror - grey"));
  EXPECT_TRUE(
      contains(sandbox.orbs({"list", "cases"}).text, "m3_mirror  M3  Mirror & co  mirror, grey, rest"));
  EXPECT_EQ(sandbox.orbs({"list", "requirements"}).text, "M1  Grey\nM3  Mirror & co\n");
  EXPECT_TRUE(contains(sandbox.orbs({"list", "renderers"}).text, "G5/M8"));
  EXPECT_TRUE(sandbox.orbs({"list", "suites"}).text.starts_with("t  "));
  EXPECT_EQ(sandbox.orbs({"list", "things"}).status, 2);
}

TEST(Plan, SaysWhatEachSceneCallsForAndWhy) {
  const Sandbox sandbox;
  const auto suite = sandbox.orbs({"effects"});
  EXPECT_EQ(suite.status, 0) << suite.text;
  EXPECT_TRUE(contains(suite.text, "mirror")) << suite.text;
  EXPECT_TRUE(contains(suite.text, "rgb")) << suite.text;
  const std::string prism = ORBS_SOURCE_DIR "/data/cases/appearance/e6_dispersion/prism_SF10.json";
  const auto one = sandbox.orbs({"effects", prism});
  EXPECT_TRUE(contains(one.text, "material 'glass' has an index that varies by")) << one.text;
  EXPECT_FALSE(contains(one.text, "mirror")) << one.text;
  EXPECT_TRUE(contains(sandbox.orbs({"effects", prism, "--json"}).text, R"("effect": "dispersion")"));
  EXPECT_EQ(sandbox.orbs({"effects", "no-such-scene"}).status, 2);
}

// Also names of scenes of other suites than the usual one are known.
TEST(Doctor, OfTheShippedConfigurationHasNoWarning) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"doctor", "--configuration", ORBS_SOURCE_DIR "/configuration.json"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "cycles")) << answer.text;
  EXPECT_FALSE(contains(answer.text, "warning")) << answer.text;
  EXPECT_FALSE(contains(answer.text, "cannot be read")) << answer.text;
}

TEST(Doctor, SaysInALineOfEachWhatIsThereAndWhatIsNot) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"doctor"});
  EXPECT_EQ(answer.status, 0);
  const auto entries = json::parse("doctor", sandbox.orbs({"doctor", "--json"}).text);
  json::ObjectReader report(entries);
  EXPECT_GT(report.objects("renderers").size(), 5U);
  EXPECT_TRUE(std::regex_search(answer.text, std::regex("\ngood +fake renderer 7.8 +orbs-scene +G5")))
      << answer.text;
  EXPECT_TRUE(contains(answer.text, "not installed: '/nowhere/at/all' was not found")) << answer.text;
}

TEST(Doctor, SaysAllOfTheRenderersThatAreNamed) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"doctor", "-r", "good,absent"});
  EXPECT_EQ(answer.status, 0);
  EXPECT_TRUE(contains(answer.text, "good\n  program   ")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "version   fake renderer 7.8")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "absent\n  program   not installed: '/nowhere/at/all' was not found"))
      << answer.text;
  EXPECT_FALSE(contains(answer.text, "noisy")) << answer.text;
  const auto wrong = sandbox.orbs({"doctor", "-r", "god"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_TRUE(contains(wrong.text, "no renderer matches 'god' (did you mean 'good'?)")) << wrong.text;
}

TEST(Doctor, NamesScenesOfAnEntryThatNoSuiteHas) {
  const Sandbox sandbox;
  sandbox.add_to_good(R"(, "scene_settings_of_scenes": {"gray": {}, "mirror": {}})");
  const auto answer = sandbox.orbs({"doctor"});
  EXPECT_TRUE(
      contains(answer.text,
               "warning: good: scene_settings_of_scenes: no suite has a scene 'gray' (did you mean 'grey'?)"))
      << answer.text;
  EXPECT_FALSE(contains(answer.text, "scene 'mirror'")) << answer.text;
}

TEST(StandardOutput, ThatCannotBeWrittenIsNoSuccess) {
  const Sandbox sandbox;
  const auto answer = sandbox.shell(ORBS_BINARY_WORD "/orbs list > /dev/full");
  EXPECT_EQ(answer.status, 2);
  EXPECT_EQ(answer.text, "orbs: standard output cannot be written: No space left on device\n");
}

TEST(Compare, PrintsAllNumbersAndTheirDefinitionsOnRequest) {
  const Sandbox sandbox;
  write_grey(sandbox, "a.exr", 0.5F);
  write_grey(sandbox, "b.exr", 0.25F);
  const auto answer = sandbox.orbs({"compare", "a.exr", "b.exr"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "l1                             0.25 radiance")) << answer.text;
  EXPECT_FALSE(contains(answer.text, "mean of"));
  EXPECT_TRUE(contains(sandbox.orbs({"compare", "a.exr", "b.exr", "--definitions"}).text, "mean of"));
}

TEST(Compare, HasStatusOneBeyondATolerance) {
  const Sandbox sandbox;
  write_grey(sandbox, "a.exr", 0.5F);
  write_grey(sandbox, "b.exr", 0.25F);
  EXPECT_EQ(sandbox.orbs({"compare", "a.exr", "b.exr", "--metric", "l1", "--max", "0.3"}).status, 0);
  EXPECT_EQ(sandbox.orbs({"compare", "a.exr", "b.exr", "--metric", "l1", "--max", "0.2"}).status, 1);
  EXPECT_EQ(sandbox.orbs({"compare", "a.exr", "b.exr", "--min", "35"}).status, 1);
  EXPECT_EQ(sandbox.orbs({"compare", "a.exr", "a.exr", "--min", "35"}).status, 0);
}

TEST(Compare, HasStatusTwoForWhatCannotBeCompared) {
  const Sandbox sandbox;
  write_grey(sandbox, "a.exr", 0.5F);
  write_grey(sandbox, "small.exr", 0.5F, 8, 8);
  write_grey(sandbox, "nan.exr", std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(sandbox.orbs({"compare", "a.exr", "small.exr"}).status, 2);
  EXPECT_EQ(sandbox.orbs({"compare", "a.exr", "nan.exr"}).status, 2);
  EXPECT_EQ(sandbox.orbs({"compare", "a.exr", "absent.exr"}).status, 2);
  EXPECT_EQ(sandbox.orbs({"compare", "a.exr", "a.exr", "--metric", "psnr", "--min", "1"}).status, 2);
}

// "noise_share" and the bias would be numbers that mean nothing.
TEST(Compare, RefusesVariancesThatCannotBe) {
  const Sandbox sandbox;
  auto image = image::make_image(16, 12, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (auto& sample : image.pixels) sample = 0.5F;
  image::write_exr(image, sandbox.folder() / "good.exr");
  EXPECT_EQ(sandbox.orbs({"compare", "good.exr", "good.exr"}).status, 0);
  for (const float value :
       {-1.0F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    image.at(3, 2, 4) = value;
    image::write_exr(image, sandbox.folder() / "bad.exr");
    for (const auto& files : {std::vector<std::string>{"good.exr", "bad.exr"}, {"bad.exr", "good.exr"}}) {
      const auto answer = sandbox.orbs({"compare", files[0], files[1]});
      EXPECT_EQ(answer.status, 2) << answer.text;
      EXPECT_TRUE(contains(answer.text, fmt::format("bad.exr: variance.G is {} at pixel (3, 2)", value)))
          << answer.text;
    }
  }
}

TEST(Compare, WritesTheErrorMaps) {
  const Sandbox sandbox;
  write_grey(sandbox, "a.exr", 0.5F);
  EXPECT_EQ(sandbox.orbs({"compare", "a.exr", "a.exr", "--maps", "maps"}).status, 0);
  EXPECT_TRUE(sandbox.has("maps/error-l1.exr"));
  EXPECT_TRUE(sandbox.has("maps/error-signed.png"));
}

// The file holds sRGB values; half of the range is 0.2140 in linear light, and that is compared.
TEST(Compare, ReadsImagesForTheScreenAsSrgb) {
  const Sandbox sandbox;
  auto image = image::make_image(16, 12, {"R", "G", "B"});
  for (auto& sample : image.pixels) sample = 1;
  image::write_png(image, sandbox.folder() / "white.png");
  for (auto& sample : image.pixels) sample = 0.5F;
  image::write_png(image, sandbox.folder() / "half.png");
  write_grey(sandbox, "half.exr", 0.2140F);
  // 8 bits: 0.5 is stored as 128/255, which is 0.2159 in linear light.
  EXPECT_EQ(sandbox.orbs({"compare", "half.png", "half.exr", "--metric", "l1", "--max", "0.003"}).status, 0);
  EXPECT_EQ(sandbox.orbs({"compare", "white.png", "half.exr", "--metric", "l1", "--max", "0.003"}).status, 1);
}

TEST(Help, NamesTheCommandsAndTheExitStatus) {
  const Sandbox sandbox;
  const auto help = sandbox.orbs({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* command : {"run", "list", "doctor", "compare", "reference"})
    EXPECT_TRUE(contains(help.text, command)) << command;
  EXPECT_TRUE(contains(sandbox.orbs({"run", "--help"}).text, "Exit status: 0"));
  EXPECT_TRUE(sandbox.orbs({"--version"}).text.starts_with("orbs "));
}

TEST(Serve, RefusesWhatIsNoRunAndAddressesThatOthersReach) {
  const Sandbox sandbox;
  auto answer = sandbox.orbs({"serve", "cases"});
  EXPECT_EQ(answer.status, 2);
  answer = sandbox.orbs({"serve"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.text.find("no outputs-* folder of a run"), std::string::npos) << answer.text;
  answer = sandbox.orbs({"serve", "--address", "0.0.0.0", "cases"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.text.find("--allow-network"), std::string::npos) << answer.text;
}

TEST(Report, NamesAFolderThatIsNoRun) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"report", "cases", "-o", "page.html"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.text.find("holds no results.json"), std::string::npos) << answer.text;
  EXPECT_FALSE(sandbox.has("page.html"));
}
