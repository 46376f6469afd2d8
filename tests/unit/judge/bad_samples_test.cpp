#include "judge/bad_samples.h"

#include "judge/difference.h"
#include "unit/judge/images.h"

#include <string>

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::judge_images;
using results::Verdict;

namespace {

// 16 x 12 px of 1000 samples: 192,000, of which 19 are 99 in a million.
image::Image with_bad_samples(const std::string& bad, const std::string& spp = "1000") {
  auto image = grey(0.25F);
  if (!bad.empty()) image.attributes["orbs.bad_samples"] = bad;
  if (!spp.empty()) image.attributes["orbs.spp"] = spp;
  return image;
}

results::TargetRecord judged_with(const std::string& bad, const std::string& spp = "1000") {
  return judged(one_case(), with_bad_samples(bad, spp), grey(0.2501F));
}

}  // namespace

TEST(BadSamples, AboveTheirShareFailAnImageThatMeetsItsGates) {
  const auto record = judged_with("20");
  EXPECT_EQ(record.verdict, Verdict::Fail);
  EXPECT_EQ(
      record.reason,
      "20 of 1.92e+05 samples were no finite number and are missing, 104 in a million; at most 100 in a "
      "million may be");
  ASSERT_EQ(record.checks.back().what, "bad_samples");
  EXPECT_FALSE(record.checks.back().passed);
  EXPECT_NEAR(record.measures.back().value, 104.17, 0.01);
}

TEST(BadSamples, UpToTheirShareAreARemark) {
  const auto record = judged_with("19");
  EXPECT_EQ(record.verdict, Verdict::PassWithRemarks);
  ASSERT_FALSE(record.remarks.empty());
  EXPECT_EQ(record.remarks.back(),
            "19 of 1.92e+05 samples were no finite number and are missing, 99 in a million");
  EXPECT_TRUE(judged_with("0").remarks.empty());
  EXPECT_TRUE(judged_with("").remarks.empty());
}

TEST(BadSamples, WhoseShareIsNotKnownAreARemark) {
  EXPECT_NE(judged_with("5", "").remarks.back().find("it does not say in orbs.spp"), std::string::npos);
  EXPECT_NE(judged_with("many").remarks.back().find("is 'many', expected the number"), std::string::npos);
}

TEST(BadSamples, FailAnImageThatChecksAloneJudge) {
  auto by_checks = one_case();
  by_checks.scenes[0].no_reference = "no reference can be had";
  const auto record = judged(by_checks, with_bad_samples("20"), grey(0.25F));
  EXPECT_EQ(record.verdict, Verdict::Fail) << record.reason;
}

// What shapes did not answer is a hole in the image as well.
TEST(BadSamples, OfPlugInsAndOfSearchesWithoutEndFailAnImage) {
  for (const char* attribute : {"orbs.plugin_faults", "orbs.unfinished_roots", "orbs.zero_normals"}) {
    auto image = with_bad_samples("0");
    image.attributes[attribute] = "19";
    EXPECT_EQ(judged(one_case(), image, grey(0.2501F)).verdict, Verdict::PassWithRemarks) << attribute;
    image.attributes[attribute] = "40";
    const auto record = judged(one_case(), image, grey(0.2501F));
    EXPECT_EQ(record.verdict, Verdict::Fail) << attribute;
    EXPECT_TRUE(record.reason.starts_with("in 1.92e+05 samples 40 ")) << record.reason;
    EXPECT_EQ("orbs." + record.checks.back().what, attribute);
    EXPECT_EQ(judge::difference_of(with_bad_samples("0"), image).attributes.at(attribute), "40");
  }
}

// Nobody can tell a surface that only touches zero from none, so these are no failure, however many.
TEST(BadSamples, UndecidedRootsAreARemarkAboveTheirShare) {
  const auto image = with_bad_samples("0");
  for (const auto& [attribute, words] :
       {std::pair{"orbs.undecided_roots", "hits rest on values"},
        std::pair{"orbs.cache_negative", "lookups of an irradiance cache"}}) {
    auto counted = image;
    counted.attributes[attribute] = "19";
    EXPECT_EQ(judged(one_case(), counted, grey(0.2501F)).verdict, Verdict::Pass) << attribute;
    EXPECT_TRUE(judged(one_case(), counted, grey(0.2501F)).remarks.empty());
    counted.attributes[attribute] = "150000";
    const auto record = judged(one_case(), counted, grey(0.2501F));
    EXPECT_EQ(record.verdict, Verdict::PassWithRemarks);
    EXPECT_TRUE(record.remarks.at(0).starts_with(std::string("in 1.92e+05 samples 150000 ") + words))
        << record.remarks[0];
  }
}

TEST(BadSamples, OfBothScenesAreMissingInADifference) {
  const auto difference = judge::difference_of(with_bad_samples("12"), with_bad_samples("8"));
  EXPECT_EQ(difference.attributes.at("orbs.bad_samples"), "20");
  EXPECT_EQ(
      judge::difference_of(with_bad_samples(""), with_bad_samples("8")).attributes.at("orbs.bad_samples"),
      "8");
  EXPECT_FALSE(judge::difference_of(with_bad_samples(""), with_bad_samples(""))
                   .attributes.contains("orbs.bad_samples"));
}
