#include "base/error.h"
#include "registry/image_size.h"

#include <gtest/gtest.h>

using namespace orbs;

namespace {

registry::Case case_with(const Rectangle& region) {
  registry::Case made;
  made.masks = {{"a", {region}, "a highlight"}};
  made.pixel_checks = {{"a", region, {1, 1, 1}, 0.1, "it is seen"}};
  return made;
}

std::string masked(const Rectangle& region, int divisor) {
  return rectangle_text(registry::reduced_case(case_with(region), divisor).masks[0].rectangles[0]);
}

registry::PixelCheck checked(const Rectangle& region, int divisor) {
  return registry::reduced_case(case_with(region), divisor).pixel_checks[0];
}

}  // namespace

TEST(ReducedCase, MasksEveryPixelThatShowsAMaskedOne) {
  EXPECT_EQ(masked({4, 8, 12, 16}, 4), "[1,2,3,4]");
  EXPECT_EQ(masked({7, 11, 9, 13}, 4), "[1,2,3,4]");
  EXPECT_EQ(masked({255, 0, 256, 1}, 8), "[31,0,32,1]");
}

TEST(ReducedCase, ChecksPixelsThatLieInTheRegionAsAWhole) {
  EXPECT_EQ(rectangle_text(checked({4, 8, 12, 16}, 4).region), "[1,2,3,4]");
  EXPECT_EQ(rectangle_text(checked({3, 7, 13, 17}, 4).region), "[1,2,3,4]");
  EXPECT_EQ(checked({3, 7, 13, 17}, 4).not_measured, "");
}

// The mean over a part of a gradient is another one: the card of a scene came out 3 % too dark at 1/4.
TEST(ReducedCase, MeasuresAMeanWithStandardErrorsOfAllItsPixelsAlone) {
  const auto reduced = [](const Rectangle& region) {
    auto made = case_with(region);
    made.pixel_checks[0].standard_errors = 4;
    return registry::reduced_case(made, 4).pixel_checks[0];
  };
  EXPECT_EQ(reduced({4, 8, 12, 16}).not_measured, "");
  EXPECT_NE(reduced({3, 7, 13, 17}).not_measured.find("not measured at 1/4"), std::string::npos);
}

TEST(ReducedCase, SaysThatARegionFillsNoPixel) {
  for (const Rectangle region : {Rectangle{256, 220, 257, 221}, {5, 5, 11, 11}, {0, 1, 16, 7}}) {
    const auto check = checked(region, 4);
    EXPECT_EQ(rectangle_text(check.region), rectangle_text(region));
    EXPECT_EQ(check.not_measured, "not measured at 1/4: these pixels of the full size fill none there");
    EXPECT_EQ(checked(region, 1).not_measured, "");
  }
}

TEST(ImageSize, IsAShareOfTheFullWidth) {
  for (const int divisor : registry::kSizeDivisors)
    EXPECT_EQ(registry::size_divisor(registry::size_text(divisor)), divisor);
  EXPECT_EQ(registry::size_text(4), "1/4");
  for (const char* wrong : {"", "1/3", "0.25", "1/16", "4"})
    EXPECT_THROW(registry::size_divisor(wrong), InputError) << wrong;
}
