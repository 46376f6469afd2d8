// orbs run --size: fewer pixels, judged by averages of the references.
#include "cli/sandbox.h"
#include "image/image_io.h"
#include "results/record.h"

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::configuration_with;
using cli_tests::contains;
using cli_tests::replace_in;
using cli_tests::Sandbox;
using results::Verdict;

namespace {

image::Image image_in(const Sandbox& sandbox, const std::string& file) {
  return image::read_image(sandbox.folder() / file);
}

results::RunRecord record_of(const Sandbox& sandbox, const std::string& run) {
  return results::read_results_file(sandbox.folder() / run / "results.json");
}

}  // namespace

TEST(ReducedSize, DividesImagesReferencesAndDifferences) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "good", "-o", "out", "--size", "1/4"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "declared G5/M8 \u00b7 measured at 1/4 M3-(2)")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "Measured at 1/4 of the width and height")) << answer.text;
  EXPECT_EQ(record_of(sandbox, "out").size, "1/4");
  for (const char* file : {"out/good/grey/result.exr", "out/good/rest/result.exr", "out/references/grey.exr",
                           "out/references/rest.exr"}) {
    const auto image = image_in(sandbox, file);
    EXPECT_EQ(image.width, 3) << file;
    EXPECT_EQ(image.height, 2) << file;
  }
}

TEST(ReducedSize, IsNotMentionedAtFullSize) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "good", "-o", "out", "--size", "1"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_FALSE(contains(answer.text, "easured at")) << answer.text;
  EXPECT_EQ(record_of(sandbox, "out").size, "1");
  EXPECT_EQ(image_in(sandbox, "out/good/grey/result.exr").width, 12);
}

TEST(ReducedSize, MayBeTheDefaultOfTheConfiguration) {
  const Sandbox sandbox;
  sandbox.write("configuration.json", configuration_with(R"("size": "1/2")"));
  EXPECT_EQ(sandbox.orbs({"run", "-r", "good", "-s", "grey", "-o", "half"}).status, 0);
  EXPECT_EQ(image_in(sandbox, "half/good/grey/result.exr").width, 6);
  EXPECT_EQ(sandbox.orbs({"run", "-r", "good", "-s", "grey", "-o", "full", "--size", "1"}).status, 0);
  EXPECT_EQ(image_in(sandbox, "full/good/grey/result.exr").width, 12);
}

TEST(ReducedSize, OfAnImageThatItDoesNotDivideIsLarger) {
  const Sandbox sandbox;
  replace_in(sandbox, "cases/m3_mirror/mirror.json", "\"width\": 12", "\"width\": 16");
  auto mirror = image::make_image(16, 8, {"R", "G", "B"});
  std::fill(mirror.pixels.begin(), mirror.pixels.end(), 0.5F);
  image::write_exr(mirror, sandbox.folder() / "references/mirror.exr");
  const auto answer = sandbox.orbs({"run", "-r", "good", "-s", "grey,mirror", "-o", "out", "--size", "1/8"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text,
                       "Measured at 1/8 of the width and height (1 at 1/4: too small for less, or "
                       "not to be divided)"))
      << answer.text;
  for (const auto& target : record_of(sandbox, "out").targets)
    EXPECT_EQ(target.verdict, Verdict::Pass) << target.target << ": " << target.reason;
  EXPECT_EQ(image_in(sandbox, "out/good/grey/result.exr").width, 3);
  EXPECT_EQ(image_in(sandbox, "out/references/grey.exr").width, 3);
  EXPECT_EQ(image_in(sandbox, "out/good/mirror/result.exr").width, 2);
}

TEST(ReducedSize, LeavesEnoughPixels) {
  const Sandbox sandbox;
  const auto answer =
      sandbox.orbs({"run", "-r", "good", "-s", "grey", "-o", "out", "--size", "1/8", "--least-side", "3"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_EQ(image_in(sandbox, "out/good/grey/result.exr").height, 4);
  EXPECT_EQ(record_of(sandbox, "out").scenes.at(0).size, "1/2");
  EXPECT_TRUE(contains(answer.text, "(1 at 1/2: too small")) << answer.text;
}

TEST(ReducedSize, NeedsARendererWithABoxFilter) {
  const Sandbox sandbox;
  sandbox.add_to_good(R"(, "box_filter": false)");
  const auto answer = sandbox.orbs({"run", "-r", "good", "-o", "out", "--size", "1/4"});
  EXPECT_EQ(answer.status, 2) << answer.text;
  EXPECT_TRUE(contains(answer.text, "not measured at 1/4: good does not filter by a box of one pixel"))
      << answer.text;
  EXPECT_FALSE(sandbox.has("out/good"));
  EXPECT_EQ(sandbox.orbs({"run", "-r", "good", "-o", "full"}).status, 0);
}

TEST(ReducedSize, OfARunStaysWhenItIsResumed) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "good", "-s", "grey,v1.5", "-o", "out", "--size", "1/2"});
  const auto kept = std::filesystem::last_write_time(sandbox.folder() / "out/good/grey/result.exr");
  std::filesystem::remove_all(sandbox.folder() / "out/good/v1.5");
  const auto refused = sandbox.orbs({"run", "--resume", "out", "--size", "1"});
  EXPECT_NE(refused.status, 0);
  EXPECT_TRUE(contains(refused.text, "--resume") && contains(refused.text, " excludes ") &&
              contains(refused.text, "--size"))
      << refused.text;
  EXPECT_FALSE(sandbox.has("out/good/v1.5"));
  const auto answer = sandbox.orbs({"run", "--resume", "out"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_EQ(image_in(sandbox, "out/good/v1.5/result.exr").width, 6);
  EXPECT_EQ(std::filesystem::last_write_time(sandbox.folder() / "out/good/grey/result.exr"), kept);
  EXPECT_EQ(record_of(sandbox, "out").size, "1/2");
}

TEST(ReducedSize, CountsTheChecksThatItCannotMeasure) {
  const Sandbox sandbox;
  replace_in(sandbox, "cases/m1_grey/case.json", "\"scenes\":", R"("pixel_checks": [
    {"scene": "grey", "region": [5, 5, 6, 6], "expected": [9, 9, 9], "tolerance": 0.1, "why": "a pixel"},
    {"scene": "grey", "region": [0, 0, 8, 4], "expected": [0.5, 0.5, 0.5], "tolerance": 0.1, "why": "two"}],
  "masks": [{"scene": "grey", "rectangles": [[0, 0, 9, 1]], "reason": "a highlight"}], "scenes":)");
  const auto answer =
      sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-s", "grey", "-o", "out", "--size", "1/4"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "Not measured: 1 pixel check, smaller than such a pixel."))
      << answer.text;
  EXPECT_TRUE(contains(sandbox.read("out/results.json"), "\"measured\": false"));
  EXPECT_EQ(sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-s", "grey", "-o", "full"}).status, 1);
}

TEST(ReducedSize, TakesTheCameraPathsThatTheMeansNeed) {
  const Sandbox sandbox;
  replace_in(sandbox, "cases/m1_grey/case.json", R"("file": "grey.json")",
             R"("file": "grey.json", "camera_paths": 3001)");
  const auto spp_at = [&](const std::string& size) {
    sandbox.orbs(
        {"run", "-r", "good", "-s", "grey", "-o", "at" + size.substr(size.size() - 1), "--size", size});
    return record_of(sandbox, "at" + size.substr(size.size() - 1)).jobs.at(0).identity.spp;
  };
  EXPECT_EQ(spp_at("1"), 8) << "96 px: the samples of the case";
  EXPECT_EQ(spp_at("1/4"), 501) << "6 px: 3001 paths, rounded up";
}

TEST(ReducedSize, AMaskThatLeavesNoPixelMakesATargetUnsupported) {
  const Sandbox sandbox;
  replace_in(
      sandbox, "cases/m1_grey/case.json", "\"scenes\":",
      R"("masks": [{"scene": "grey", "rectangles": [[0, 0, 9, 5]], "reason": "a highlight"}], "scenes":)");
  const auto answer = sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-o", "out", "--size", "1/4"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "not measured at 1/4: the mask leaves no pixel to compare"))
      << answer.text;
  EXPECT_EQ(sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-o", "full"}).status, 0);
}

// Orbs' own tracer filters by a box: its image of fewer pixels must agree with the averages of its reference.
TEST(ReducedSize, OfTheBuiltInTracerHasTheMeansOfTheFullOne) {
  const Sandbox sandbox;
  sandbox.write("configuration.json",
                R"({"format": "orbs-configuration/1", "stands_alone": true, "defaults": {"suite": "t"},
"suites": [{"name": "t", "cases": "cases", "references": "references"}],
"renderers": [{"name": "orbs", "executable": "{build}/orbs-tracer", "declares": "G5/M8/L4",
  "command": ["{executable}", "{scene}", "-o", "{output}", "--spp", "{spp}", "--seed", "{seed}", "--threads", "1"]}]})");
  sandbox.write("cases/m1_grey/grey.json", R"({"format": "orbs-scene/1", "name": "s",
 "camera": {"position": [0,3,4], "look_at": [0,0,0], "width": 96, "height": 64},
 "materials": [{"name": "m", "type": "lambert", "reflectance": [0.5,0.7,0.2]}],
 "meshes": [{"name": "p", "generator": "plane", "half_size": 1, "material": "m"}],
 "instances": [{"mesh": "p"}], "lights": [], "environment": [1,1,1]})");
  sandbox.write("cases/m1_grey/case.json", R"({"format": "orbs-case/2", "requirement": "M1", "title": "Grey",
 "tests": "t", "typical_mistake": "m", "scenes": [{"name": "grey", "file": "grey.json", "spp": 64}]})");
  std::filesystem::remove_all(sandbox.folder() / "cases/m3_mirror");
  std::filesystem::remove(sandbox.folder() / "references/grey.exr");
  const auto rendered = sandbox.orbs({"reference", "-s", "grey", "--spp", "64", "--threads", "1"});
  ASSERT_TRUE(sandbox.has("references/grey.exr")) << rendered.text;
  const auto answer = sandbox.orbs({"run", "-o", "out", "--size", "1/4"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  const auto run = record_of(sandbox, "out");
  ASSERT_EQ(run.targets.size(), 1U);
  EXPECT_EQ(run.targets[0].reference_provenance.at("averaged_over"), "4 x 4 px");
  int means = 0;
  for (const auto& measure : run.targets[0].measures)
    if (measure.name.starts_with("mean_ratio_")) {
      EXPECT_NEAR(measure.value, 0, 0.007) << measure.name;
      ++means;
    }
  EXPECT_EQ(means, 3);
  const auto image = image_in(sandbox, "out/orbs/grey/result.exr");
  EXPECT_EQ(image.width, 24);
  EXPECT_EQ(image.height, 16);
}

TEST(ReducedSize, HasAQualificationOfItsOwn) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-o", "half", "--size", "1/2"});
  // 6 x 4 px are too few for gates that see 2 % of light; what counts here is which file holds what they see.
  const auto answer = sandbox.orbs({"qualify", "half", "-r", "good", "-c", "m1_grey"});
  EXPECT_TRUE(contains(answer.text, "of 2 gates are qualified")) << answer.text;
  EXPECT_FALSE(contains(answer.text, "control image is not accepted")) << answer.text;
  EXPECT_TRUE(sandbox.has("references/qualification-1-2.json"));
  EXPECT_FALSE(sandbox.has("references/qualification.json"));
  const auto seen = [&](const std::string& folder, const std::string& size) {
    sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-o", folder, "--size", size});
    return record_of(sandbox, folder).cases.at(0).smallest_error_seen;
  };
  EXPECT_TRUE(seen("next", "1/2").starts_with("at 1/2: "));
  EXPECT_EQ(seen("full", "1"), "");
}
