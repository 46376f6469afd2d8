// How a verdict tells noise from error, and that the noise must be there.
#include "judge/noise.h"

#include "base/random.h"
#include "unit/judge/images.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::judge_images;
using results::Verdict;

// Slope of the sRGB curve at 0.25: 1.055/2.4 * 0.25^(1/2.4 - 1) = 0.98686, so variance v gives an error of
// (255*0.98686)^2 v.
TEST(Noise, GoesThroughTheSlopeOfTheCurve) {
  const double slope = 1.055 / 2.4 * std::pow(0.25, 1 / 2.4 - 1);
  const auto mse = judge::noise_mse_srgb8(grey(0.9F, 0.001F), grey(0.25F));
  ASSERT_TRUE(mse);
  EXPECT_NEAR(*mse, 255 * 255 * slope * slope * 0.001, 1e-4);
  EXPECT_NEAR(judge::psnr_srgb8_of(*mse), -10 * std::log10(slope * slope * 0.001), 1e-4);
}

// A firefly on a dark pixel: from 12.92 * 0.001 it can go up to 1, and no further.
TEST(Noise, IsNoLargerThanTheClampLeavesRoomFor) {
  const double room = 1 - 12.92 * 0.001;
  EXPECT_NEAR(judge::noise_mse_srgb8(grey(0.9F, 10), grey(0.001F)).value(), 255 * 255 * room * room, 0.01);
}

TEST(Noise, IsNoneWhereTheClampHoldsAndUnknownWithoutVariance) {
  EXPECT_EQ(judge::noise_mse_srgb8(grey(1.5F, 0.1F), grey(1.5F)), 0.0);
  EXPECT_EQ(judge::noise_mse_srgb8(grey(0.5F), grey(0.5F)), std::nullopt);
}

// Noise of a standard deviation of 0.03 on 0.25 is 30.55 dB, of which 35 dB is a factor 2.8 away. The noise
// is known as such, or said to be a tenth.
TEST(Judge, ADifferenceThatNoiseExplainsIsInconclusive) {
  const auto noisy = judged(one_case(), noisy_grey(0.25F, 0.03F), grey_32(0.25F));
  EXPECT_EQ(noisy.verdict, Verdict::Inconclusive);
  EXPECT_NE(noisy.reason.find("needs about 2.8 times the samples"), std::string::npos) << noisy.reason;
  EXPECT_TRUE(noisy.remarks.empty());
  auto bold = noisy_grey(0.25F, 0.03F);
  for (std::size_t i = 0; i < bold.pixels.size(); ++i)
    if (i % 6 >= 3) bold.pixels[i] /= 100;
  EXPECT_EQ(judged(one_case(), bold, grey_32(0.25F)).verdict, Verdict::Fail);
}

// 12 % more light is 31 dB by itself, and no number of samples makes 35 dB of that.
TEST(Judge, NoiseIsNoExcuseForABiasThatMissesTheGateByItself) {
  const auto biased = judged(one_case(), noisy_grey(0.28F, 0.03F), grey_32(0.25F));
  EXPECT_EQ(biased.verdict, Verdict::Fail);
  ASSERT_FALSE(biased.remarks.empty());
  EXPECT_NE(biased.remarks[0].find("brighter"), std::string::npos) << biased.remarks[0];
}

// 2.8 % more light is 43 dB: with more samples the image meets this gate, whatever others say of its mean.
TEST(Judge, ANoisyImageWhoseBiasMeetsTheGateIsInconclusiveAndRemarkedUpon) {
  const auto biased = judged(one_case(), noisy_grey(0.257F, 0.03F), grey_32(0.25F));
  EXPECT_EQ(biased.verdict, Verdict::Inconclusive) << biased.reason;
  ASSERT_FALSE(biased.remarks.empty());
  EXPECT_NE(biased.remarks[0].find("brighter"), std::string::npos) << biased.remarks[0];
}

// The noise of a renderer that does not state it is read where the reference is smooth.
TEST(Judge, ADifferenceThatNoiseExplainsIsInconclusiveWithoutVariancesToo) {
  auto noisy = grey_32(0.25F);
  for (std::size_t i = 0; i < noisy.pixels.size(); ++i)
    noisy.pixels[i] += 0.2F * static_cast<float>(unit_random(mix(1, i / 3)) - 0.5);
  const auto record = judged(one_case(), noisy, grey_32(0.25F));
  EXPECT_EQ(record.verdict, Verdict::Inconclusive) << record.reason;
  EXPECT_NE(record.reason.find("times the samples"), std::string::npos) << record.reason;
  auto far_off = noisy;
  for (float& value : far_off.pixels) value += 0.05F;
  EXPECT_EQ(judged(one_case(), far_off, grey_32(0.25F)).verdict, Verdict::Fail);
}

// A reference without a smooth place: its edges tell nothing of the noise where nothing is wrong with them.
TEST(Judge, TheNoiseOfATexturedImageIsKnownWithoutVariancesToo) {
  auto reference = grey_32(0.25F);
  for (std::size_t i = 0; i < reference.pixels.size(); ++i)
    if ((i / 3 / 2 + i / 3 / 64) % 2 == 0) reference.pixels[i] = 0.4F;
  auto noisy = reference;
  for (std::size_t i = 0; i < noisy.pixels.size(); ++i)
    noisy.pixels[i] += 0.2F * static_cast<float>(unit_random(mix(1, i / 3)) - 0.5);
  const auto record = judged(one_case(), noisy, reference);
  EXPECT_EQ(record.verdict, Verdict::Inconclusive) << record.reason;
  auto wrong = reference;
  for (float& value : wrong.pixels) value = 0.65F - value;  // dark and bright are exchanged
  EXPECT_EQ(judged(one_case(), wrong, reference).verdict, Verdict::Fail);
}

// A copy has no noise of its own, whatever it states.
TEST(Judge, ACopyOfTheReferenceFails) {
  const auto reference = noisy_grey(0.25F, 0.01F);
  for (const auto& copy : {reference, image::select_rgb(reference, "")}) {
    const auto record = judged(one_case(), copy, reference);
    EXPECT_EQ(record.verdict, Verdict::Fail);
    EXPECT_NE(record.reason.find("nearer to the reference than the reference's own noise allows"),
              std::string::npos)
        << record.reason;
  }
}

// The reference with the noise of another image upon it is as far from the reference as a render would be.
TEST(Judge, ACopyOfTheReferenceWithNoiseUponItFails) {
  const auto reference = noisy_grey(0.25F, 0.004F);
  auto copy = reference;
  for (std::size_t i = 0; i < copy.pixels.size(); ++i)
    if (i % 6 < 3) copy.pixels[i] += 0.02F * static_cast<float>(unit_random(mix(2, i / 6)) - 0.5);
  const auto record = judged(one_case(), image::select_rgb(copy, ""), reference);
  EXPECT_EQ(record.verdict, Verdict::Fail) << record.reason;
  EXPECT_NE(record.reason.find("of the reference's own noise"), std::string::npos) << record.reason;
}

// Variances of single samples would excuse errors of many times the noise.
TEST(Judge, VariancesThatAreTooLargeAreNotUsedAndSaidToBeSo) {
  auto overstated = noisy_grey(0.25F, 0.01F);
  for (std::size_t i = 0; i < overstated.pixels.size(); ++i)
    if (i % 6 >= 3) overstated.pixels[i] *= 64;
  const auto record = judged(one_case(), overstated, grey_32(0.25F));
  EXPECT_EQ(record.verdict, Verdict::PassWithRemarks) << record.reason;
  ASSERT_FALSE(record.remarks.empty());
  EXPECT_NE(record.remarks[0].find("its variances are not used"), std::string::npos) << record.remarks[0];
  auto gradient = overstated;
  for (std::size_t i = 0; i < gradient.pixels.size(); ++i)
    if (i % 6 < 3) gradient.pixels[i] *= 1 + 0.09F * (static_cast<float>(i / 6 % 32) / 16 - 1);
  EXPECT_GE(judged(one_case(), gradient, grey_32(0.25F)).remarks.size(), 2U);
}

TEST(Judge, AReferenceTooNoisyForTheGateIsSaidToBeSo) {
  const auto record = judged(one_case(), noisy_grey(0.25F, 0.001F), noisy_grey(0.25F, 0.03F));
  EXPECT_EQ(record.verdict, Verdict::Inconclusive);
  EXPECT_NE(record.reason.find("the reference is too noisy"), std::string::npos) << record.reason;
}

// 10 % of noise on 1024 pixels leaves 0.3 % of the mean. Its square is infinite as a float, or zero: neither
// may make the mean certain. The infinite ones are a fault of their own; of the zeros one cannot tell whether
// there is noise, but in an image of one colour, which shows none.
TEST(Judge, VariancesBeyondTheRangeOfFloatsAreNotUsedAndSaidToBeSo) {
  auto by = one_case();
  by.gates = {{"mean_ratio_r", -0.001, 0.001}};
  for (const float value : {1e25F, 1e-25F}) {
    const auto noisy = noisy_grey(value, 0.1F * value);
    ASSERT_TRUE(noisy.pixels[3] == 0 || std::isinf(noisy.pixels[3]));
    const auto record = judged(by, noisy, grey_32(value));
    EXPECT_EQ(record.verdict, Verdict::Inconclusive) << value << " " << record.reason;
    ASSERT_EQ(record.remarks.size(), 1U) << value;
    EXPECT_NE(record.remarks[0].find("its variances are not used"), std::string::npos) << record.remarks[0];
    auto far_off = noisy;
    for (std::size_t i = 0; i < far_off.pixels.size(); ++i)
      if (i % 6 < 3) far_off.pixels[i] *= 1.2F;
    EXPECT_EQ(judged(by, far_off, grey_32(value)).verdict, Verdict::Fail) << value;
  }
  EXPECT_EQ(judge::variance_problem(grey(1e-25F, 0)), "");
  EXPECT_EQ(judge::variance_problem(noisy_grey(1e-10F, 1e-12F)), "");
  auto free_of_noise = noisy_grey(0.5F, 0.1F);
  for (std::size_t i = 0; i < free_of_noise.pixels.size(); ++i)
    if (i % 6 >= 3) free_of_noise.pixels[i] = 0;
  EXPECT_EQ(judge::variance_problem(free_of_noise), "");
}
