// Copies of references that were computed, which have no noise that could be found in a copy.
#include "judge/judge.h"
#include "unit/judge/images.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::judge_images;
using results::Verdict;

namespace {

// A gradient in which all values differ, as a formula gives it.
image::Image computed_gradient() {
  auto image = grey_32(0);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = 0.2F + 0.1F * std::sqrt(static_cast<float>(i));
  return image;
}

}  // namespace

TEST(Judge, ACopyOfAComputedReferenceFailsUnlessItsRendererHasNoNoise) {
  const auto computed = computed_gradient();
  const auto copied = judged(one_case(), computed, computed);
  EXPECT_EQ(copied.verdict, Verdict::Fail);
  EXPECT_NE(copied.reason.find("it equals the reference, which was computed"), std::string::npos)
      << copied.reason;
  auto nearly = computed;
  for (float& value : nearly.pixels) value = std::nextafter(value, 2.0F);
  EXPECT_EQ(judged(one_case(), nearly, computed).verdict, Verdict::Fail);
  for (float& value : nearly.pixels) value *= 1.00001F;
  EXPECT_EQ(judged(one_case(), nearly, computed).verdict, Verdict::Pass);
  results::TargetRecord record;
  record.target = "a";
  judge::judge_image(one_case(), computed, {"", computed, ""},
                     {.result_noise = metrics::ResultNoise::NoiseFree}, record);
  EXPECT_EQ(record.verdict, Verdict::Pass) << record.reason;
  EXPECT_EQ(judged(one_case(), grey(0.25F), grey(0.25F)).verdict, Verdict::Pass)
      << "one colour proves nothing";
}

// A small ball before one colour: few values differ, and those that vary within their pixels prove it.
TEST(Judge, ACopyOfAComputedReferenceWithFewValuesFails) {
  auto computed = grey_32(0.25F);
  for (int y = 10; y < 18; ++y)
    for (int x = 10; x < 18; ++x)
      for (std::size_t c = 0; c < 3; ++c) computed.at(x, y, c) = 0.3F + 0.01F * static_cast<float>(x * y);
  EXPECT_EQ(judged(one_case(), computed, computed).verdict, Verdict::Fail);
}

// Half of it black: the border is an edge between pixels, and all colours are of lamps.
TEST(Judge, AnImageOfEvenColoursMayEqualItsReference) {
  auto computed = grey_32(0.25F);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 16; ++x)
      for (std::size_t c = 0; c < 3; ++c) computed.at(x, y, c) = 0;
  EXPECT_EQ(judged(one_case(), computed, computed).verdict, Verdict::Pass);
}
