#include "metrics/alignment.h"

#include "metrics/compare.h"
#include "unit/metrics/images.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace {

using namespace orbs::metrics;
using namespace orbs::metrics_test;
using orbs::image::Image;
using orbs::image::make_image;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

}  // namespace

TEST(MetricsAlignment, ImagesOfDifferentSizeAreNotComparable) {
  const auto report =
      check_alignment(make_image(256, 512, {"R", "G", "B"}), make_image(512, 512, {"R", "G", "B"}));
  EXPECT_EQ(report.alignment, Alignment::WrongSize);
  EXPECT_EQ(report.reason, "the result is 256 x 512 px, the reference 512 x 512 px");
}

TEST(MetricsAlignment, ImagesWithoutPixelsAreNotComparable) {
  EXPECT_EQ(check_alignment(Image{}, Image{}).alignment, Alignment::WrongSize);
}

TEST(MetricsAlignment, AMissingChannelIsNamedTogetherWithTheOnesThatAreThere) {
  const Image whole = make_image(4, 4, {"R", "G", "B"});
  const auto grey = check_alignment(make_image(4, 4, {"Y"}), whole);
  EXPECT_EQ(grey.alignment, Alignment::WrongChannels);
  EXPECT_EQ(grey.reason, "the result has no channel R, G, B; it has Y");
  const auto layer = check_alignment(whole, make_image(4, 4, {"R", "layer.G", "B"}));
  EXPECT_EQ(layer.alignment, Alignment::WrongChannels);
  EXPECT_EQ(layer.reason, "the reference has no channel G; it has R, layer.G, B");
}

TEST(MetricsAlignment, BadPixelsAreCountedByKindAndTheFirstIsShown) {
  const Image reference = constant_image(6, 5, 0.5F);
  Image result = reference;
  result.at(4, 2, 1) = std::nanf("");
  result.at(4, 2, 2) = -1.0F;  // the same pixel, a second kind
  result.at(0, 3, 0) = kInfinity;
  result.at(1, 3, 0) = -kInfinity;  // infinite and negative
  result.at(1, 3, 1) = -kInfinity;  // counted as one pixel
  const auto report = check_alignment(result, reference);
  EXPECT_EQ(report.alignment, Alignment::InvalidPixels);
  EXPECT_EQ(report.result.nan, 1U);
  EXPECT_EQ(report.result.infinite, 2U);
  EXPECT_EQ(report.result.negative, 2U);
  EXPECT_EQ(report.reason,
            "the result has pixels with bad numbers: 1 with NaN, 2 infinite, 2 negative; the first at "
            "(4, 2), channel G, value nan");
}

TEST(MetricsAlignment, ABadReferenceIsNoBetterThanABadResult) {
  const Image result = constant_image(4, 4, 0.5F);
  Image reference = result;
  reference.at(3, 3, 2) = kInfinity;
  const auto report = check_alignment(result, reference);
  EXPECT_EQ(report.alignment, Alignment::InvalidPixels);
  EXPECT_EQ(report.reason,
            "the reference has pixels with bad numbers: 0 with NaN, 1 infinite, 0 negative; the first at "
            "(3, 3), channel B, value inf");
}

TEST(MetricsAlignment, NegativePixelsAreAFaultUnlessAllowedAndCountedInBothCases) {
  const Image reference = constant_image(4, 4, 0.5F);
  Image result = reference;
  result.at(1, 0, 0) = -1e-6F;
  EXPECT_EQ(check_alignment(result, reference).alignment, Alignment::InvalidPixels);
  const auto allowed = check_alignment(result, reference, NegativePixels::Allowed);
  EXPECT_EQ(allowed.alignment, Alignment::Comparable);
  EXPECT_EQ(allowed.result.negative, 1U);
  result.at(2, 0, 0) = std::nanf("");
  const auto with_nan = check_alignment(result, reference, NegativePixels::Allowed);
  EXPECT_EQ(with_nan.alignment, Alignment::InvalidPixels);
  EXPECT_EQ(with_nan.result.first, "(2, 0), channel R, value nan");
}

TEST(MetricsAlignment, MinusZeroAndTheLargestFloatAreValid) {
  Image image = constant_image(2, 2, std::numeric_limits<float>::max());
  image.at(0, 0, 0) = -0.0F;
  EXPECT_EQ(check_alignment(image, image).alignment, Alignment::Comparable);
}

TEST(MetricsAlignment, NothingIsComputedOnImagesThatAreNotComparable) {
  const Image reference = constant_image(16, 16, 0.5F);
  Image result = reference;
  result.at(15, 15, 2) = std::nanf("");
  // A mask hides errors, not faults.
  const Comparison c = compare(result, reference, {{{15, 15, 16, 16}}, {}});
  EXPECT_EQ(c.alignment.alignment, Alignment::InvalidPixels);
  EXPECT_TRUE(c.measurements.empty());
  EXPECT_TRUE(c.maps.empty());
  EXPECT_FALSE(value_of(c, "l1").has_value());
}
