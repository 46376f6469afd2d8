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

TEST(DivisorOfImage, DividesBothSidesAndLeavesEnough) {
  const registry::ReducedSize eighth{8, 16};
  EXPECT_EQ(registry::divisor_of_image(512, 512, eighth), 8);
  EXPECT_EQ(registry::divisor_of_image(128, 128, eighth), 8);
  EXPECT_EQ(registry::divisor_of_image(128, 96, eighth), 4) << "12 px would be left";
  EXPECT_EQ(registry::divisor_of_image(96, 128, eighth), 4);
  EXPECT_EQ(registry::divisor_of_image(64, 64, eighth), 4);
  EXPECT_EQ(registry::divisor_of_image(64, 64, {2, 16}), 2) << "no more than the run's";
  EXPECT_EQ(registry::divisor_of_image(1024, 340, eighth), 4) << "340 = 4 x 85";
  EXPECT_EQ(registry::divisor_of_image(16, 16, eighth), 1);
  EXPECT_EQ(registry::divisor_of_image(12, 8, eighth), 1) << "smaller than that at full size";
  EXPECT_EQ(registry::divisor_of_image(1023, 767, eighth), 1);
  EXPECT_EQ(registry::divisor_of_image(12, 8, {8, 1}), 4);
}

// A case has scenes of several sizes.
TEST(ReducedCase, DividesEachTargetByItsOwnNumber) {
  auto made = case_with({8, 8, 16, 16});
  made.pixel_checks.push_back({"b", {8, 8, 16, 16}, {1, 1, 1}, 0.1, "it is seen"});
  const auto reduced =
      registry::reduced_case(made, [](const std::string& target) { return target == "b" ? 2 : 8; });
  EXPECT_EQ(rectangle_text(reduced.masks[0].rectangles[0]), "[1,1,2,2]");
  EXPECT_EQ(rectangle_text(reduced.pixel_checks[0].region), "[1,1,2,2]");
  EXPECT_EQ(rectangle_text(reduced.pixel_checks[1].region), "[4,4,8,8]");
}
