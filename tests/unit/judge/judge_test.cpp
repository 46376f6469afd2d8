#include "judge/judge.h"

#include "image/image_io.h"
#include "judge/difference.h"
#include "judge/gate.h"
#include "judge/noise.h"
#include "judge/provenance.h"
#include "judge/qualified.h"
#include "metrics/table.h"
#include "structure/source_files.h"
#include "unit/judge/images.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::judge_images;
using results::Verdict;

// Equal steps everywhere: the error in sRGB is known in closed form. 0.25 -> 0.26 linear is encoded .53710 ->
// .54681, and 20 log10(1 / 0.00971) = 40.3 dB; 0.25 -> 0.28 is .02807 and 31.0 dB.
TEST(Judge, TheGateSeparatesASmallErrorFromALargeOne) {
  EXPECT_EQ(judged(one_case(), grey(0.26F), grey(0.25F)).verdict, Verdict::PassWithRemarks);
  const auto bad = judged(one_case(), grey(0.28F), grey(0.25F));
  EXPECT_EQ(bad.verdict, Verdict::Fail);
  EXPECT_NE(bad.reason.find("at least 35 is needed"), std::string::npos) << bad.reason;
}

namespace {

// Grey with an even S1.
image::Image polarised_grey(float s1) {
  auto image = image::make_image(
      16, 16, {"R", "G", "B", "S1.R", "S1.G", "S1.B", "S2.R", "S2.G", "S2.B", "S3.R", "S3.G", "S3.B"});
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = i % 12 < 3 ? 0.5F : (i % 12 < 6 ? s1 : 0);
  return image;
}

}  // namespace

TEST(Judge, StokesParametersThatAreNoNumbersAreInvalidPixels) {
  auto broken = polarised_grey(0.1F);
  broken.at(3, 2, 4) = std::numeric_limits<float>::quiet_NaN();
  const auto record = judged(one_case(), broken, polarised_grey(0.1F));
  EXPECT_EQ(record.verdict, Verdict::InvalidPixels);
  EXPECT_EQ(record.reason, "S1.G is nan at pixel (3, 2)");
}

TEST(Judge, StokesParametersMustBeThereAndRight) {
  auto polarised = one_case();
  polarised.gates.push_back({"stokes_error", {}, 0.02});
  EXPECT_EQ(judged(polarised, polarised_grey(0.1F), polarised_grey(0.1F)).verdict, Verdict::Pass);
  const auto turned = judged(polarised, polarised_grey(-0.1F), polarised_grey(0.1F));
  EXPECT_EQ(turned.verdict, Verdict::Fail);
  EXPECT_NE(turned.reason.find("Stokes parameters are off by 23.1 %"), std::string::npos) << turned.reason;
  const auto without = judged(polarised, image::select_rgb(polarised_grey(0), ""), polarised_grey(0.1F));
  EXPECT_EQ(without.verdict, Verdict::Fail);
  EXPECT_NE(without.reason.find("has no Stokes parameters"), std::string::npos) << without.reason;
  EXPECT_EQ(
      judged(polarised, image::select_rgb(polarised_grey(0), ""), image::select_rgb(polarised_grey(0), ""))
          .verdict,
      Verdict::Pass);
}

namespace {

// Grey, a depth beside it.
image::Image grey_at(float depth_m) {
  auto image = image::make_image(16, 16, {"R", "G", "B", "depth.Z"});
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = i % 4 < 3 ? 0.5F : depth_m;
  return image;
}

}  // namespace

TEST(Judge, LayersMustBeThereAndRight) {
  auto layered = one_case();
  layered.gates.push_back({"layer_pixels", {}, 0});
  layered.gates.push_back({"layer_error", {}, 0.001});
  EXPECT_EQ(judged(layered, grey_at(2), grey_at(2)).verdict, Verdict::Pass);
  const auto wrong = judged(layered, grey_at(2.5F), grey_at(2));
  EXPECT_EQ(wrong.verdict, Verdict::Fail);
  EXPECT_NE(wrong.reason.find("the layer 'depth' is 1.25 times what it should be"), std::string::npos)
      << wrong.reason;
  const auto broken = judged(layered, grey_at(std::numeric_limits<float>::quiet_NaN()), grey_at(2));
  EXPECT_EQ(broken.verdict, Verdict::Fail);
  const auto without = judged(layered, image::select_rgb(grey_at(2), ""), grey_at(2));
  EXPECT_EQ(without.verdict, Verdict::Fail);
  EXPECT_NE(without.reason.find("it lacks layers that the scene asks for: depth"), std::string::npos)
      << without.reason;
}

TEST(Judge, NumbersCarryTheirDefinitions) {
  const auto record = judged(one_case(), grey(0.26F), grey(0.25F));
  ASSERT_FALSE(record.measures.empty());
  for (const auto& measure : record.measures) EXPECT_GT(measure.definition.size(), 20U) << measure.name;
}

// They would excuse any error.
TEST(Judge, VariancesThatCannotBeAreNotUsedAndSaidToBeSo) {
  for (const float impossible : {-1.0F, std::numeric_limits<float>::infinity(), std::nanf("")}) {
    auto wrong = noisy_grey(0.5F, 0.01F);
    const auto channel = image::channel_index(wrong, "variance.G");
    ASSERT_GE(channel, 0);
    wrong.at(3, 4, static_cast<std::size_t>(channel)) = impossible;
    const auto record = judged(one_case(), wrong, grey_32(0.25F));
    EXPECT_EQ(record.verdict, Verdict::Fail) << record.reason;
    ASSERT_FALSE(record.remarks.empty());
    EXPECT_NE(record.remarks.front().find("at pixel (3, 4): its variances are not used"), std::string::npos);
  }
}

// A missing reference must not look like a pass.
TEST(Judge, AMissingReferenceIsNeverAPass) {
  results::TargetRecord record;
  record.target = "a";
  judge::judge_image(one_case(), grey(0.5F), {"a.exr", std::nullopt, "there is no reference a.exr"}, {},
                     record);
  EXPECT_EQ(record.verdict, Verdict::MissingReference);
  EXPECT_EQ(record.reason, "there is no reference a.exr");
}

TEST(Judge, AReferenceOfAnotherSizeIsAMissingOne) {
  EXPECT_EQ(judged(one_case(), grey(0.5F), image::make_image(8, 8, {"R", "G", "B"})).verdict,
            Verdict::MissingReference);
}

// 4 % are 40 dB: the gate is met, and the record says what it does not look at.
TEST(Judge, ABiasThatTheGateDoesNotSeeIsARemark) {
  const auto record = judged(one_case(), grey(0.26F), grey(0.25F));
  EXPECT_EQ(record.verdict, Verdict::PassWithRemarks);
  EXPECT_EQ(record.reason, record.remarks[0]);
  ASSERT_EQ(record.remarks.size(), 2U);  // and that the blocks are
  EXPECT_TRUE(record.remarks[0].starts_with("bias: the means differ by more than noise: R 4 % brighter"))
      << record.remarks[0];
  EXPECT_TRUE(judged(one_case(), grey(0.25F), grey(0.25F)).remarks.empty());
}

TEST(Judge, AMeanRatioIsAConditionWhereTheCaseAsksForIt) {
  auto strict = one_case();
  for (const char* metric : {"mean_ratio_r", "mean_ratio_g", "mean_ratio_b"})
    strict.gates.push_back({metric, -0.01, 0.01});
  EXPECT_EQ(judged(strict, grey(0.252F), grey(0.25F)).verdict, Verdict::PassWithRemarks);
  const auto bright = judged(strict, grey(0.253F), grey(0.25F));
  EXPECT_EQ(bright.verdict, Verdict::Fail);
  EXPECT_EQ(
      bright.reason,
      "R is 1.2 % brighter (1.2 to 1.2 %), at most 1 % is allowed; G is 1.2 % brighter (1.2 to 1.2 %), at most 1 % "
      "is allowed; B is 1.2 % brighter (1.2 to 1.2 %), at most 1 % is allowed");
  EXPECT_EQ(bright.checks.size(), 4U);
  // Noise of 4 % in each pixel: the interval of the mean is 0.5 % on either side.
  EXPECT_EQ(judged(strict, noisy_grey(0.25F, 0.01F), grey_32(0.25F)).verdict, Verdict::Pass);
  const auto unsure = judged(strict, noisy_grey(0.252F, 0.01F), grey_32(0.25F));
  EXPECT_EQ(unsure.verdict, Verdict::Inconclusive);
  EXPECT_NE(unsure.reason.find("times the samples"), std::string::npos) << unsure.reason;
  EXPECT_EQ(judged(strict, noisy_grey(0.2575F, 0.01F), grey_32(0.25F)).verdict, Verdict::Fail);
}

TEST(Judge, AMeanOnTheLimitNeedsNoNumberOfSamples) {
  const metrics::Measurement measured{&metrics::kMeanRatioR, 0.01, {}, 0.008, 0.012};
  const auto on_it = judge::check_gate({"mean_ratio_r", -0.01, 0.01}, measured, {});
  EXPECT_EQ(on_it.verdict, Verdict::Inconclusive);
  EXPECT_NE(on_it.reason.find("it lies on the limit"), std::string::npos) << on_it.reason;
}

TEST(Judge, SoftEdgesFailWhereTheCaseAsksForSharpOnes) {
  auto stripes = grey_32(0.25F);
  for (int y = 0; y < stripes.height; ++y)
    for (int x = 0; x < stripes.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) stripes.at(x, y, c) = x % 8 < 4 ? 0.25F : 0.5F;
  auto soft = stripes;
  for (int y = 0; y < stripes.height; ++y)
    for (int x = 1; x + 1 < stripes.width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        soft.at(x, y, c) = (stripes.at(x - 1, y, c) + 2 * stripes.at(x, y, c) + stripes.at(x + 1, y, c)) / 4;
  auto sharp = one_case();
  sharp.gates = {{"psnr_srgb8", 20}};
  EXPECT_EQ(judged(sharp, soft, stripes).verdict, Verdict::Pass);
  sharp.gates.push_back({"edge_blur", -0.9, 0.9});
  const auto record = judged(sharp, soft, stripes);
  EXPECT_EQ(record.verdict, Verdict::Fail);
  EXPECT_EQ(record.reason, "edges are blurred by 1 (1 to 1) of a 3 x 3 px filter, at most 0.9 is allowed");
  EXPECT_EQ(record.checks.back().what, "edge_blur");
  sharp.gates.back() = {"edge_blur", -1.1, 1.1};
  EXPECT_EQ(judged(sharp, soft, stripes).verdict, Verdict::Pass);
}

// Black in blue, so that there is nothing to compare it with.
TEST(Judge, AGateOfWhatTheReferenceDoesNotShowIsMet) {
  auto black_blue = grey(0.25F);
  for (std::size_t i = 2; i < black_blue.pixels.size(); i += 3) black_blue.pixels[i] = 0;
  auto gated = one_case();
  gated.gates.insert(gated.gates.end(), {{"mean_ratio_b", -0.01, 0.01}, {"edge_blur", -0.2, 0.2}});
  const auto record = judged(gated, black_blue, black_blue);
  EXPECT_EQ(record.verdict, Verdict::Pass);
  ASSERT_EQ(record.checks.size(), 3U);
  EXPECT_EQ(record.checks[1].reason, "the mean of B has nothing to be compared with");
  EXPECT_EQ(record.checks[2].reason, "the reference has no edges to be compared with");
}

TEST(Judge, AGateOfAMetricWithoutANumberIsInconclusive) {
  auto gated = one_case();
  gated.gates = {{"ssim", 0.9}};
  const auto tiny = image::select_rgb(image::make_image(8, 8, {"R", "G", "B"}), "");
  const auto record = judged(gated, tiny, tiny);
  EXPECT_EQ(record.verdict, Verdict::Inconclusive);
  EXPECT_EQ(record.reason, "ssim has no value for this image");
}

TEST(Judge, EveryNumberOfTheTableCanBeAGate) {
  for (const auto& metric : metrics::kMetrics) {
    auto gated = one_case();
    gated.gates = {{std::string(metric.name), -1e6, 1e9}};
    const auto record = judged(gated, noisy_grey(0.25F, 0.03F), noisy_grey(0.5F, 0.03F, 2));
    ASSERT_EQ(record.checks.size(), 1U);
    EXPECT_EQ(record.checks[0].what, metric.name);
    EXPECT_TRUE(passes(record.verdict)) << record.reason;
  }
}

TEST(Judge, AGateOfAnUnknownMetricIsRefusedWithItsPlaceAndTheNearestName) {
  const structure::TestFolder scratch("judge-gate");
  scratch.write("m1/a.json", "{}");
  scratch.write("m1/case.json", R"({"format": "orbs-case/2", "requirement": "M1", "title": "t", "tests": "t",
"typical_mistake": "m", "scenes": [{"name": "a", "file": "a.json"}],
"gates": [{"metric": "l1", "max": 1, "reason": "r"},
          {"metric": "psnr_srgb", "min": 30, "reason": "r"}]})");
  const auto read = registry::load_case(scratch.path() / "m1" / "case.json");
  try {
    judge::refuse_unknown_metrics(read);
    FAIL() << "no error";
  } catch (const InputError& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find("there is no metric 'psnr_srgb' (did you mean 'psnr_srgb8'?)"), std::string::npos)
        << what;
    EXPECT_NE(what.find("reading the gate at " + read.file.string() + ":4"), std::string::npos) << what;
  }
}

// Prose decides nothing, so a stored qualification survives it; every number of a gate, mask or check counts.
TEST(Qualified, TheHashOfAGateIsThatOfWhatDecidesTheVerdict) {
  const structure::TestFolder scratch("judge-hash");
  scratch.write("a.exr", "bytes of a reference");
  const auto hash = [&](const registry::Case& of) { return judge::gate_hash(of, "a", scratch.path()); };
  const auto before = one_case();
  auto reworded = before;
  reworded.title = reworded.tests = "other words";
  reworded.gates[0].reason = "another reason";
  reworded.masks = {{"b", {{0, 0, 1, 1}}, "a mask of another target"}};
  EXPECT_EQ(hash(reworded), hash(before));
  std::vector<registry::Case> changed(5, before);
  changed[0].gates[0].min = 34;
  changed[1].masks = {{"a", {{0, 0, 1, 1}}, "r"}};
  changed[2].pixel_checks = {{"a", {0, 0, 1, 1}, {1, 1, 1}, 0.1, "w"}};
  changed[3].path_shares = {{"a", "ESDL", 0.01}};
  changed[4].negative_values = "they are right";
  for (const auto& one : changed) EXPECT_NE(hash(one), hash(before));
  const auto old = hash(before);
  scratch.write("a.exr", "bytes of another reference");
  EXPECT_NE(hash(before), old);
}

TEST(Judge, AGateMayAskForAMetricThatIsNotAlwaysComputed) {
  auto flip = one_case();
  flip.gates = {{"flip", std::nullopt, 0.02}};
  EXPECT_EQ(judged(flip, grey(0.25F), grey(0.25F)).verdict, Verdict::Pass);
  EXPECT_EQ(judged(flip, grey(0.5F), grey(0.25F)).verdict, Verdict::Fail);
}

TEST(Judge, NoiseIsNoExcuseForAnImageThatIsFarOff) {
  EXPECT_EQ(judged(one_case(), grey(0.6F, 0.03F * 0.03F), grey(0.25F)).verdict, Verdict::Fail);
}

TEST(Judge, MaskedPixelsDoNotCount) {
  auto result = grey(0.25F);
  result.at(3, 2, 0) = 100;
  auto masked = one_case();
  EXPECT_EQ(judged(masked, result, grey(0.25F)).verdict, Verdict::Fail);
  masked.masks = {{"a", {{3, 2, 4, 3}}, "a highlight"}};
  EXPECT_EQ(judged(masked, result, grey(0.25F)).verdict, Verdict::Pass);
  EXPECT_EQ(judged(masked, result, grey(0.25F), "b").verdict,
            Verdict::Fail);  // the mask is of the other image
}

TEST(Judge, APixelCheckFailsWhereTheWholeImagePasses) {
  auto checked = one_case();
  checked.pixel_checks = {{"a", {0, 0, 2, 2}, {0.25, 0.25, 0.25}, 1e-5, "what is emitted is seen"}};
  EXPECT_EQ(judged(checked, grey(0.25F), grey(0.25F)).verdict, Verdict::Pass);
  const auto record = judged(checked, grey(0.2501F), grey(0.25F));
  EXPECT_EQ(record.verdict, Verdict::Fail);
  EXPECT_NE(record.reason.find("what is emitted is seen"), std::string::npos) << record.reason;
  ASSERT_EQ(record.checks.size(), 2U);
  EXPECT_TRUE(record.checks[0].passed);
  EXPECT_FALSE(record.checks[1].passed);
}

TEST(Judge, APathClassMustCarryItsShareOfTheReference) {
  auto paths = one_case();
  paths.path_shares = {{"a", "ESDL", 0.01}};
  auto reference = grey(0.25F);
  EXPECT_EQ(judged(paths, grey(0.25F), reference).verdict,
            Verdict::Inconclusive);  // the provenance says nothing
  reference.attributes["orbs.path.ESDL"] = "0.005";
  EXPECT_EQ(judged(paths, grey(0.25F), reference).verdict, Verdict::Inconclusive);
  reference.attributes["orbs.path.ESDL"] = "0.02";
  EXPECT_EQ(judged(paths, grey(0.25F), reference).verdict, Verdict::Pass);
  EXPECT_EQ(judged(paths, grey(0.25F), reference).reference_provenance.at("path.ESDL"), "0.02");
}

// What the renderer's own double precision shows counts beside the gates, and alone proves nothing.
TEST(Judge, RoundingMayDecideNoMoreThanTheCaseAllows) {
  auto bounded = one_case();
  bounded.condition = {1e-3, "a reason"};
  const auto with = [&](const results::JobCondition& condition) {
    results::TargetRecord record;
    record.target = "a";
    judge::judge_image(bounded, grey(0.25F), {"a.exr", grey(0.25F), ""}, {.condition = condition}, record);
    return record;
  };
  EXPECT_EQ(with({}).verdict, Verdict::Pass) << "the renderer was not asked";
  results::JobCondition condition;
  condition.spp = 16;
  condition.pixels = 1e-3;
  EXPECT_TRUE(with(condition).checks.back().passed);
  EXPECT_EQ(with(condition).verdict, Verdict::Pass);
  condition.pixels = 1.1e-3;
  EXPECT_EQ(with(condition).verdict, Verdict::Fail);
  condition.problem = "it crashed";
  EXPECT_EQ(with(condition).verdict, Verdict::Inconclusive);
  condition = {};
  condition.spp = 16;
  bounded.scenes[0].no_reference = "checks alone judge it";
  bounded.pixel_checks = {{"a", {0, 0, 1, 1}, {0.25, 0.25, 0.25}, 0, "w", "the region is too small"}};
  EXPECT_EQ(with(condition).verdict, Verdict::Inconclusive);
}

TEST(Judge, AGateMayBeAnUpperBoundOfAnotherMetric) {
  auto strict = one_case();
  strict.gates = {{"l1", std::nullopt, 0.005}};
  EXPECT_EQ(judged(strict, grey(0.2525F), grey(0.25F)).verdict, Verdict::PassWithRemarks);
  EXPECT_EQ(judged(strict, grey(0.26F), grey(0.25F)).verdict, Verdict::Fail);
}

TEST(Difference, SubtractsColoursAndAddsVariances) {
  const auto difference = judge::difference_of(grey(0.75F, 0.25F), grey(0.25F, 0.5F));
  EXPECT_EQ(difference.at(0, 0, 0), 0.5F);
  EXPECT_EQ(difference.at(0, 0, 3), 0.75F);
}

TEST(Difference, OfTheSameSamplesScattersByWhatIsLeft) {
  const auto rendered = [](float value, float variance, const char* seed) {
    auto image = grey(value, variance);
    image.attributes["orbs.program"] = "orbs-tracer";
    image.attributes["orbs.spp"] = "64";
    image.attributes["orbs.seed"] = seed;
    return image;
  };
  const auto full = rendered(0.75F, 0.5F, "1");
  EXPECT_EQ(judge::difference_of(full, rendered(0.25F, 0.375F, "1")).at(0, 0, 3), 0.125F);
  EXPECT_EQ(judge::difference_of(full, rendered(0.25F, 0.75F, "1")).at(0, 0, 3), 0);
  EXPECT_EQ(judge::difference_of(full, rendered(0.25F, 0.375F, "2")).at(0, 0, 3), 0.875F);
  auto in_parts = rendered(0.25F, 0.375F, "1");  // its first part has that seed
  in_parts.attributes["orbs.settings"] = "--spp 32 --seed 1 + --spp 32 --seed 2";
  EXPECT_EQ(judge::difference_of(full, in_parts).at(0, 0, 3), 0.875F);
}

// Noise makes pixels of a difference negative, which in a rendered image would be a fault.
TEST(Judge, ADifferenceMayBeNegative) {
  auto subtracting = one_case();
  subtracting.differences = {{"d", "a", "b"}};
  EXPECT_EQ(judged(subtracting, grey(-0.001F), grey(-0.001F), "d").verdict, Verdict::Pass);
}

TEST(Reference, OfADifferenceIsTheDifferenceOfTheReferences) {
  const structure::TestFolder scratch("runner-reference");
  scratch.write("keep", "");
  auto subtracting = one_case();
  subtracting.differences = {{"d", "a", "b"}};
  image::write_exr(grey(0.75F), scratch.path() / "a.exr");
  EXPECT_FALSE(judge::load_reference(subtracting, "d", scratch.path()).image);
  image::write_exr(grey(0.5F), scratch.path() / "b.exr");
  const auto reference = judge::load_reference(subtracting, "d", scratch.path());
  ASSERT_TRUE(reference.image) << reference.problem;
  EXPECT_EQ(reference.image->at(0, 0, 0), 0.25F);
}

TEST(Reference, OfASceneThatIsAnotherOneByDefinitionIsThatOfTheOther) {
  const structure::TestFolder scratch("runner-same-reference");
  scratch.write("keep", "");
  auto sharing = one_case();
  sharing.scenes[0].reference = "elsewhere";
  EXPECT_NE(judge::load_reference(sharing, "a", scratch.path()).problem.find("elsewhere.exr"),
            std::string::npos);
  image::write_exr(grey(0.75F), scratch.path() / "elsewhere.exr");
  image::write_exr(grey(0.5F), scratch.path() / "b.exr");
  EXPECT_EQ(judge::load_reference(sharing, "a", scratch.path()).image->at(0, 0, 0), 0.75F);
  sharing.differences = {{"d", "a", "b"}};
  EXPECT_EQ(judge::load_reference(sharing, "d", scratch.path()).image->at(0, 0, 0), 0.25F);
}

TEST(Reference, OfAnotherVersionOfItsSceneIsNone) {
  const structure::TestFolder scratch("runner-version");
  scratch.write("keep", "");
  auto image = grey(0.75F);
  image::write_exr(image, scratch.path() / "b.exr");
  image.attributes["orbs.scene_hash"] = "1234";
  image::write_exr(image, scratch.path() / "a.exr");
  EXPECT_TRUE(judge::load_reference(one_case(), "a", scratch.path(), {{"a", "1234"}}).image);
  const auto old = judge::load_reference(one_case(), "a", scratch.path(), {{"a", "5678"}});
  EXPECT_FALSE(old.image);
  EXPECT_EQ(old.problem,
            fmt::format("scene 'a' has changed since its reference was rendered: its hash is now 5678, the "
                        "provenance in {} says 1234; 'orbs reference --scene a --accept \"why it has "
                        "changed\"' renders it again",
                        (scratch.path() / "a.exr").string()));
  // One without a provenance record is taken at its word.
  EXPECT_TRUE(judge::load_reference(one_case(), "b", scratch.path(), {{"b", "5678"}}).image);
}

TEST(Reference, WhosePixelsAreNotThoseOfItsProvenanceIsNone) {
  const structure::TestFolder scratch("runner-pixels");
  scratch.write("keep", "");
  auto image = grey(0.75F);
  image.attributes["orbs.image_hash"] = judge::image_hash(image);
  image::write_exr(image, scratch.path() / "a.exr");
  EXPECT_TRUE(judge::load_reference(one_case(), "a", scratch.path()).image);
  image.at(1, 1, 0) += 0.25F;
  image::write_exr(image, scratch.path() / "a.exr");
  const auto changed = judge::load_reference(one_case(), "a", scratch.path());
  EXPECT_FALSE(changed.image);
  EXPECT_NE(changed.problem.find("is not the image that was accepted"), std::string::npos) << changed.problem;
}

TEST(ImageHash, IsOfThePixelsAndTheirNamesWhateverTheirOrder) {
  const auto image = grey(0.75F, 0.5F);
  auto other_order =
      image::make_image(image.width, image.height, {"variance.R", "variance.G", "variance.B", "B", "G", "R"});
  for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel)
    for (std::size_t c = 0; c < 6; ++c) other_order.pixels[6 * pixel + c] = c < 3 ? 0.5F : 0.75F;
  EXPECT_EQ(judge::image_hash(image), judge::image_hash(other_order));
  auto renamed = image;
  renamed.channels[0] = "X";
  EXPECT_NE(judge::image_hash(image), judge::image_hash(renamed));
  auto darker = image;
  darker.pixels[0] -= 1e-6F;
  EXPECT_NE(judge::image_hash(image), judge::image_hash(darker));
}

TEST(Maps, AreWrittenAsNumbersAndAsImages) {
  const structure::TestFolder scratch("runner-maps");
  scratch.write("keep", "");
  const auto comparison = metrics::compare(grey(0.5F), grey(0.25F));
  const auto maps = judge::write_maps(grey(0.5F), comparison, scratch.path());
  EXPECT_FALSE(maps.empty());
  for (const auto& map : maps) {
    EXPECT_FALSE(map.definition.empty()) << map.name;
    EXPECT_TRUE(std::filesystem::exists(scratch.path() / map.image)) << map.name;
    EXPECT_TRUE(std::filesystem::exists(scratch.path() / fmt::format("error-{}.png", map.name)));
  }
}
