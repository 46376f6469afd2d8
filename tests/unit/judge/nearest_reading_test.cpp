// Images that come as Radiance pictures, from writers that cut off what does not fit and from those that
// round.
#include "judge/nearest_reading.h"

#include "base/files.h"
#include "image/image_io.h"
#include "structure/source_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using structure::TestFolder;

constexpr int kSize = 64;

enum class Writer { CutsOff, Rounds };

// A floor that is red and dark in the other colours, with an even part, where errors do not average out.
image::Image reference() {
  auto image = image::make_image(kSize, kSize, {"R", "G", "B"});
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const float shade =
          y < kSize / 2 ? 1 : 0.3F + 0.011F * static_cast<float>(x) + 0.0037F * static_cast<float>(y);
      image.at(x, y, 0) = 0.83F * shade;
      image.at(x, y, 1) = 0.0871F * shade;
      image.at(x, y, 2) = 0.0309F * shade;
    }
  return image;
}

std::string rgbe(const image::Image& image, Writer writer) {
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 64\n";
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    const float* colour = &image.pixels[i];
    int exponent = 0;
    const double share =
        std::frexp(static_cast<double>(std::max({colour[0], colour[1], colour[2]})), &exponent);
    // Rounded, the largest mantissa would be 256.
    if (writer == Writer::Rounds && share * 256 >= 255.5) ++exponent;
    for (std::size_t c = 0; c < 3; ++c) {
      const double mantissa = std::ldexp(static_cast<double>(colour[c]), 8 - exponent);
      bytes += static_cast<char>(
          static_cast<int>(writer == Writer::Rounds ? std::floor(mantissa + 0.5) : mantissa));
    }
    bytes += static_cast<char>(exponent + 128);
  }
  return bytes;
}

image::Image image_of(const std::string& bytes) {
  const TestFolder folder("nearest-reading");
  write_file(folder.path() / "a.hdr", bytes);
  return image::read_rgb_with_steps(folder.path() / "a.hdr");
}

// The largest relative error of the mean over blocks of 8 x 8 pixels, of all colours.
double worst_block(const image::Image& image, const image::Image& expected) {
  constexpr int kBlock = 8;
  double worst = 0;
  for (int top = 0; top < kSize; top += kBlock)
    for (int left = 0; left < kSize; left += kBlock)
      for (std::size_t c = 0; c < 3; ++c) {
        double found = 0;
        double right = 0;
        for (int y = top; y < top + kBlock; ++y)
          for (int x = left; x < left + kBlock; ++x) {
            found += static_cast<double>(image.at(x, y, c));
            right += static_cast<double>(expected.at(x, y, c));
          }
        worst = std::max(worst, std::abs(found / right - 1));
      }
  return worst;
}

TEST(NearestReading, ARightImageIsRightHoweverItsWriterRounds) {
  const auto expected = reference();
  for (const auto writer : {Writer::CutsOff, Writer::Rounds}) {
    const auto raw = image_of(rgbe(expected, writer));
    EXPECT_GT(worst_block(raw, expected), 0.01) << "the format alone is off by as much";
    const auto read = judge::nearest_reading(raw, expected);
    ASSERT_TRUE(read);
    EXPECT_LT(worst_block(*read, expected), 0.008);
    EXPECT_FALSE(image::has_same_colours(*read, expected)) << "and is no copy";
  }
}

TEST(NearestReading, AWrongImageStaysWrong) {
  const auto expected = reference();
  for (const auto writer : {Writer::CutsOff, Writer::Rounds})
    for (const float factor : {0.93F, 1.07F}) {
      auto wrong = expected;
      for (auto& value : wrong.pixels) value *= factor;
      const auto read = judge::nearest_reading(image_of(rgbe(wrong, writer)), expected);
      ASSERT_TRUE(read);
      double sum = 0;
      double right = 0;
      for (std::size_t pixel = 0; pixel < expected.pixel_count(); ++pixel) {
        sum += static_cast<double>(read->pixels[pixel * read->channel_count()]);
        right += static_cast<double>(expected.pixels[3 * pixel]);
      }
      EXPECT_NEAR(sum / right, static_cast<double>(factor), 0.008) << "of red, the brightest";
    }
}

// Whoever writes an EXR could state steps as large as the errors.
TEST(NearestReading, StepsThatNoSuchPictureHasAreIgnored) {
  const auto expected = reference();
  auto image = image_of(rgbe(expected, Writer::Rounds));
  for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel)
    for (std::size_t c = 0; c < 3; ++c) {
      image.pixels[6 * pixel + c] *= 1.5F;
      image.pixels[6 * pixel + 3 + c] = 10;
    }
  const auto read = judge::nearest_reading(image, expected);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->pixels, image.pixels);
}

TEST(NearestReading, OtherImagesAreAsTheyAre) {
  EXPECT_FALSE(judge::nearest_reading(reference(), reference()));
}

}  // namespace
