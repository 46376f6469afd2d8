// Pixel checks that know their noise, and targets that they alone judge.
#include "unit/judge/images.h"

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::judge_images;
using results::Verdict;

namespace {

registry::Case case_with_check(double expected, double tolerance, double standard_errors) {
  auto made = one_case();
  made.scenes[0].no_reference = "its light is known";
  made.pixel_checks = {
      {"a", {0, 0, 16, 12}, {expected, expected, expected}, tolerance, "known", "", standard_errors}};
  return made;
}

results::TargetRecord judged_alone(const registry::Case& by, const image::Image& result) {
  results::TargetRecord record;
  record.target = "a";
  judge::judge_image(by, result, {{}, std::nullopt, "'a' has no reference"}, {}, record);
  return record;
}

}  // namespace

TEST(JudgeChecks, AloneTheyDecide) {
  EXPECT_EQ(judged_alone(case_with_check(0.5, 0, 0), grey(0.5F)).verdict, Verdict::Pass);
  const auto wrong = judged_alone(case_with_check(0.5, 0.01, 0), grey(0.52F));
  EXPECT_EQ(wrong.verdict, Verdict::Fail);
  EXPECT_NE(wrong.reason.find("expected (0.5, 0.5, 0.5) within 0.01 (known)"), std::string::npos)
      << wrong.reason;
  EXPECT_EQ(judged_alone(case_with_check(0, 0, 0), grey(-0.1F)).verdict, Verdict::InvalidPixels);
}

TEST(JudgeChecks, WhatCannotBeMeasuredDoesNotPass) {
  auto small = case_with_check(0.5, 0, 0);
  small.pixel_checks[0].not_measured = "not measured at 1/8";
  EXPECT_EQ(judged_alone(small, grey(0.5F)).verdict, Verdict::Inconclusive);
}

// 192 pixels of variance 0.0192: the standard error of their mean is 0.01.
TEST(JudgeChecks, NoiseIsToldFromErrors) {
  const auto verdict = [](float value, double tolerance) {
    return judged_alone(case_with_check(0.5, tolerance, 4), grey(value, 0.0192F)).verdict;
  };
  EXPECT_EQ(verdict(0.505F, 0.05), Verdict::Pass);
  EXPECT_EQ(verdict(0.515F, 0.05), Verdict::Inconclusive);
  EXPECT_EQ(verdict(0.585F, 0.05), Verdict::Inconclusive);
  EXPECT_EQ(verdict(0.595F, 0.05), Verdict::Fail);
  EXPECT_EQ(judged_alone(case_with_check(0.5, 0.05, 4), grey(0.54F)).verdict, Verdict::Pass);
}

// A black image whose variances are zero, too, claims that no sample has met light; where another check
// expects black, it is one colour where there are two.
TEST(JudgeChecks, OneColourIsRefusedWhereAnotherIsExpected) {
  auto two = case_with_check(0.5, 0.01, 4);
  two.pixel_checks[0].region = {0, 0, 8, 12};
  EXPECT_EQ(judged_alone(two, grey(0, 0.0F)).verdict, Verdict::ConstantImage)
      << "whatever variances it states";
  EXPECT_EQ(judged_alone(two, grey(0.5F, 0.0F)).verdict, Verdict::Pass);
  two.pixel_checks.push_back({"a", {8, 0, 16, 12}, {0, 0, 0}, 0, "the umbra", "", 0});
  EXPECT_EQ(judged_alone(two, grey(0, 0.0F)).verdict, Verdict::ConstantImage);
}

// Rows of 0.4 and 0.6: half the mean square of the steps is 0.01, and 192 pixels have the standard error
// 0.0072.
TEST(JudgeChecks, NoiseThatIsNotStatedIsReadOffTheRegion) {
  auto image = grey(0.4F);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) += y % 2 == 0 ? 0.0F : 0.2F;
  EXPECT_EQ(judged_alone(case_with_check(0.53, 0.01, 4), image).verdict, Verdict::Inconclusive);
  EXPECT_EQ(judged_alone(case_with_check(0.56, 0.01, 4), image).verdict, Verdict::Fail);
  EXPECT_EQ(judged_alone(case_with_check(0.53, 0.01, 0), image).verdict, Verdict::Fail);
}

TEST(JudgeChecks, AZeroIsAZero) {
  EXPECT_EQ(judged_alone(case_with_check(0, 0, 0), grey(0)).verdict, Verdict::Pass);
  auto leak = grey(0);
  leak.at(3, 4, 1) = 1e-20F;
  EXPECT_EQ(judged_alone(case_with_check(0, 0, 0), leak).verdict, Verdict::Fail);
}

// Two seeds that both met no light have no scatter, which says nothing of the light that they have not met.
TEST(JudgeChecks, ABlackRegionIsNoProofThatLightIsMissing) {
  const auto verdict_on = [](image::Image image, double standard_errors) {
    auto one_case = case_with_check(0.001, 0.0001, standard_errors);
    one_case.pixel_checks[0].region = {0, 0, 8, 12};
    for (std::size_t c = 0; c < 3; ++c) image.at(12, 3, c) = 1;  // it has found light elsewhere
    return judged_alone(one_case, image);
  };
  const auto black = verdict_on(grey(0, 0.0F), 4);
  EXPECT_EQ(black.verdict, Verdict::Inconclusive);
  EXPECT_NE(black.reason.find("all its samples are black"), std::string::npos) << black.reason;
  // Without noise, or in a check that allows none, a black region is wrong.
  EXPECT_EQ(verdict_on(grey(0), 4).verdict, Verdict::Fail);
  EXPECT_EQ(verdict_on(grey(0, 0.0F), 0).verdict, Verdict::Fail);
  // What is not black has its noise.
  EXPECT_EQ(verdict_on(grey(0.0005F, 0.0F), 4).verdict, Verdict::Fail);
}

// Four pixels, one of which has been hit once, elsewhere hits of the same size: one more or less is no error.
// Of hits that are a hundredth of it many would have to be missing.
TEST(JudgeChecks, LightThatFewSamplesHaveFoundIsNoProof) {
  const auto verdict_on = [](float hit, double expected) {
    auto one_case = case_with_check(expected, 0.001, 4);
    one_case.pixel_checks[0].region = {4, 4, 6, 6};
    auto image = grey(0.1F, 0.0F);
    for (const auto& [x, y] : {std::pair{4, 4}, {12, 3}, {9, 9}})
      for (std::size_t c = 0; c < 3; ++c) {
        image.at(x, y, c) += hit;
        image.at(x, y, static_cast<std::size_t>(image::channel_index(image, "variance.R")) + c) = hit * hit;
      }
    return judged_alone(one_case, image).verdict;
  };
  EXPECT_EQ(verdict_on(0.2F, 0.35), Verdict::Inconclusive) << "too dark by one hit in a pixel";
  EXPECT_EQ(verdict_on(0.2F, 0.1), Verdict::Inconclusive) << "too bright by a quarter of a hit";
  EXPECT_EQ(verdict_on(0.002F, 0.35), Verdict::Fail);
}
