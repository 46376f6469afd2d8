#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "structure/source_files.h"
#include "unit/image/png_bytes.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fs = std::filesystem;

namespace {

using namespace orbs::image;
using orbs::InputError;
using orbs::image_test::png_bytes;
using orbs::image_test::png_chunk;
using orbs::structure::TestFolder;

// Every value differs, is no half and has both signs.
Image numbered_target(int width, int height, std::vector<std::string> channels) {
  Image image = make_image(width, height, std::move(channels));
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = 0.1F * static_cast<float>(i) - 1.0F / 3.0F;
  return image;
}

void expect_same_channels(const Image& read, const Image& written) {
  ASSERT_EQ(read.width, written.width);
  ASSERT_EQ(read.height, written.height);
  ASSERT_EQ(read.channel_count(), written.channel_count());
  for (std::size_t c = 0; c < written.channel_count(); ++c) {
    const int found = channel_index(read, written.channels[c]);
    ASSERT_GE(found, 0) << written.channels[c] << " was renamed";
    for (int y = 0; y < written.height; ++y)
      for (int x = 0; x < written.width; ++x)
        ASSERT_EQ(read.at(x, y, static_cast<std::size_t>(found)), written.at(x, y, c)) << written.channels[c];
  }
}

std::string error_of_reading(const fs::path& file) {
  try {
    read_image(file);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace

TEST(ImageIo, AnExrKeepsEveryChannelByItsName) {
  const TestFolder folder("image-names");
  const Image image = numbered_target(
      5, 3,
      {"R", "G", "B", "variance.R", "variance.G", "variance.B", "path.ESDL.R", "path.ESDL.G", "path.ESDL.B",
       "path.EDSSL-T.R", "path.EDSSL-T.G", "path.EDSSL-T.B", "path.other.B", "A", "Z", "Y", "red", "x"});
  write_exr(image, folder.path() / "a.exr");
  expect_same_channels(read_image(folder.path() / "a.exr"), image);
}

TEST(ImageIo, AnExrReadsColourChannelsInTheOrderRedGreenBlue) {
  const TestFolder folder("image-order");
  write_exr(numbered_target(2, 2, {"B", "variance.B", "R", "variance.R", "G", "variance.G"}),
            folder.path() / "a.exr");
  const Image read = read_image(folder.path() / "a.exr");
  EXPECT_EQ(read.channels,
            (std::vector<std::string>{"R", "G", "B", "variance.R", "variance.G", "variance.B"}));
}

TEST(ImageIo, AnExrOfOneChannelIsAnImage) {
  const TestFolder folder("image-single");
  const Image image = numbered_target(4, 4, {"Y"});
  write_exr(image, folder.path() / "a.exr");
  expect_same_channels(read_image(folder.path() / "a.exr"), image);
}

TEST(ImageIo, AnExrKeepsTextAttributesAndNothingElse) {
  const TestFolder folder("image-attributes");
  Image image = numbered_target(2, 2, {"R", "G", "B"});
  image.attributes = {{"orbs.seed", "7"},
                      {"orbs.a-name-that-is-longer-than-31-characters", "kept"},
                      {"orbs.settings", "{\"spp\": [1, 2]}\nsecond line, ü"},
                      {"Software", "orbs-tracer"}};
  write_exr(image, folder.path() / "a.exr");
  EXPECT_EQ(read_image(folder.path() / "a.exr").attributes, image.attributes);
}

TEST(ImageIo, HalfPrecisionRoundsToElevenBitsAndFloatKeepsEveryBit) {
  const TestFolder folder("image-half");
  const Image image = numbered_target(8, 8, {"R", "G", "B"});
  write_exr(image, folder.path() / "half.exr", Precision::Half);
  const Image half = read_image(folder.path() / "half.exr");
  bool rounded = false;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    // Round to nearest: half a unit in the last of 11 significant bits.
    EXPECT_NEAR(half.pixels[i], image.pixels[i], std::fabs(image.pixels[i]) * 0x1p-11F);
    rounded = rounded || half.pixels[i] != image.pixels[i];
  }
  EXPECT_TRUE(rounded);
}

TEST(ImageIo, NanAndInfinityComeBackAsTheyWere) {
  const TestFolder folder("image-nan");
  Image image = make_image(2, 1, {"R", "G", "B"});
  image.pixels = {std::nanf(""), std::numeric_limits<float>::infinity(),
                  0.0F,          -std::numeric_limits<float>::infinity(),
                  -2.0F,         -0.0F};
  for (const auto precision : {Precision::Half, Precision::Float}) {
    write_exr(image, folder.path() / "a.exr", precision);
    const Image read = read_image(folder.path() / "a.exr");
    EXPECT_TRUE(std::isnan(read.pixels[0]));
    for (std::size_t i = 1; i < 6; ++i) EXPECT_EQ(read.pixels[i], image.pixels[i]);
    EXPECT_TRUE(std::signbit(read.pixels[5]));
  }
}

TEST(ImageIo, AValueBeyondTheLargestHalfIsRefusedInsteadOfBecomingInfinite) {
  const TestFolder folder("image-beyond-half");
  Image image = make_image(3, 2, {"R", "G", "B"});
  image.at(0, 0, 0) = 65519.0F;  // rounds to 65504, the largest half
  write_exr(image, folder.path() / "a.exr", Precision::Half);
  EXPECT_EQ(read_image(folder.path() / "a.exr").at(0, 0, 0), 65504.0F);
  image.at(2, 1, 1) = 65520.0F;
  try {
    write_exr(image, folder.path() / "a.exr", Precision::Half);
    FAIL() << "no error";
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()),
              (folder.path() / "a.exr").string() +
                  ": 65520 in channel G at pixel (2, 1) does not fit into half floats; write floats");
  }
}

// A variance may be far above or below what a half holds.
TEST(ImageIo, BesideHalfColoursVariancesStayFloats) {
  const TestFolder folder("image-variance");
  Image image = make_image(3, 1, {"R", "variance.R"});
  const std::vector<float> variances{1e9F / 3.0F, 1e-20F / 3.0F, 0.0F};
  for (int x = 0; x < 3; ++x) image.at(x, 0, 1) = variances[static_cast<std::size_t>(x)];
  write_exr(image, folder.path() / "a.exr", Precision::Half);
  const Image read = read_image(folder.path() / "a.exr");
  const int index = channel_index(read, "variance.R");
  ASSERT_GE(index, 0);
  for (int x = 0; x < 3; ++x)
    EXPECT_EQ(read.at(x, 0, static_cast<std::size_t>(index)), variances[static_cast<std::size_t>(x)]);
}

TEST(ImageIo, TheSameImageGivesTheSameBytes) {
  const TestFolder folder("image-bytes");
  const Image image = numbered_target(16, 16, {"R", "G", "B"});
  write_exr(image, folder.path() / "a.exr");
  write_exr(image, folder.path() / "b.exr");
  write_png(image, folder.path() / "a.png");
  write_png(image, folder.path() / "b.png");
  EXPECT_EQ(orbs::read_file(folder.path() / "a.exr"), orbs::read_file(folder.path() / "b.exr"));
  EXPECT_EQ(orbs::read_file(folder.path() / "a.png"), orbs::read_file(folder.path() / "b.png"));
}

TEST(ImageIo, WritingLeavesNothingBesideTheFile) {
  const TestFolder folder("image-beside");
  write_exr(numbered_target(4, 4, {"R", "G", "B"}), folder.path() / "a.exr");
  write_png(numbered_target(4, 4, {"R", "G", "B"}), folder.path() / "a.exr.png");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 2);
}

TEST(ImageIo, AFailedWriteLeavesTheOldImage) {
  const TestFolder folder("image-old");
  const Image old = numbered_target(4, 4, {"R", "G", "B"});
  write_exr(old, folder.path() / "a.exr");
  EXPECT_THROW(write_exr(numbered_target(4, 4, {"R", "R", "B"}), folder.path() / "a.exr"), InputError);
  expect_same_channels(read_image(folder.path() / "a.exr"), old);
  EXPECT_THROW(write_exr(old, folder.path() / "missing" / "a.exr"), InputError);
}

TEST(ImageIo, APngHoldsTheNearestOf256Steps) {
  const TestFolder folder("image-png");
  Image image = make_image(2, 1, {"R", "G", "B", "A"});
  image.pixels = {0.0F, 1.0F, 100.4F / 255.0F, 0.3F, -0.5F, 7.0F, 100.6F / 255.0F, 0.3F};
  write_png(image, folder.path() / "a.png");
  const Image read = read_image(folder.path() / "a.png");
  ASSERT_EQ(read.channels, (std::vector<std::string>{"R", "G", "B"}));
  const std::vector<float> expected{0, 255, 100, 0, 255, 101};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_FLOAT_EQ(read.pixels[i] * 255.0F, expected[i]);
}

TEST(ImageIo, APngOfOneChannelIsGreyAndOneWithNanIsRefused) {
  const TestFolder folder("image-grey");
  Image image = make_image(2, 2, {"Y"});
  image.at(1, 0, 0) = 1.0F;
  write_png(image, folder.path() / "a.png");
  EXPECT_EQ(read_image(folder.path() / "a.png").pixels, image.pixels);
  image.at(0, 0, 0) = std::nanf("");
  EXPECT_THROW(write_png(image, folder.path() / "a.png"), InputError);
}

TEST(ImageIo, ColoursBesideAlphaComeBackAsStored) {
  const TestFolder folder("image-alpha");
  orbs::write_file(folder.path() / "a.png", png_bytes(1, 1, 8, 6, std::string("\0\xff\x80\x40\x33", 5)));
  const Image read = read_image(folder.path() / "a.png");
  ASSERT_EQ(read.channels, (std::vector<std::string>{"R", "G", "B", "A"}));
  const std::vector<float> expected{255, 128, 64, 51};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_FLOAT_EQ(read.pixels[i] * 255.0F, expected[i]);
}

TEST(ImageIo, ADoubtfulColourProfileIsReadWithoutAWord) {
  const TestFolder folder("image-profile");
  orbs::write_file(folder.path() / "a.png", png_bytes(1, 1, 8, 2, std::string("\0\x0a\x14\x1e", 4),
                                                      png_chunk("iCCP", "no profile at all")));
  testing::internal::CaptureStderr();
  const Image read = read_image(folder.path() / "a.png");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_FLOAT_EQ(read.pixels[2] * 255.0F, 30.0F);
}

TEST(ImageIo, APortableFloatMapIsReadFromItsLastRowUp) {
  const TestFolder folder("image-pfm");
  // The format stores the bottom row first; scale -1 means little-endian.
  const std::vector<float> values{0, 1, 2, 3, 4, 5};
  std::string bytes = "PF\n1 2\n-1.0\n";
  const std::size_t header = bytes.size();
  bytes.resize(header + 24);
  std::memcpy(&bytes[header], values.data(), 24);
  orbs::write_file(folder.path() / "a.pfm", bytes);
  EXPECT_EQ(read_image(folder.path() / "a.pfm").pixels, (std::vector<float>{3, 4, 5, 0, 1, 2}));
}

TEST(ImageIo, OnlyIntegerPixelsCountAsDisplayEncoded) {
  const TestFolder folder("image-ldr");
  write_png(numbered_target(2, 2, {"R", "G", "B"}), folder.path() / "eight.png");
  orbs::write_file(folder.path() / "sixteen.png", png_bytes(1, 1, 16, 0, std::string("\0\x80\x00", 3)));
  write_exr(numbered_target(2, 2, {"R", "G", "B"}), folder.path() / "half.exr", Precision::Half);
  orbs::write_file(
      folder.path() / "radiance.hdr",
      std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n") + std::string("\x80\x80\x80\x81", 4));
  EXPECT_TRUE(is_ldr_file(folder.path() / "eight.png"));
  EXPECT_TRUE(is_ldr_file(folder.path() / "sixteen.png"));
  EXPECT_FALSE(is_ldr_file(folder.path() / "half.exr"));
  EXPECT_FALSE(is_ldr_file(folder.path() / "radiance.hdr"));
  EXPECT_FLOAT_EQ(read_image(folder.path() / "sixteen.png").pixels[0], 32768.0F / 65535.0F);
}

TEST(ImageIo, AMissingFileAFolderAndAnUnknownEndingAreSaidPlainly) {
  const TestFolder folder("image-missing");
  fs::create_directories(folder.path() / "folder.exr");
  folder.write("notes.txt", "text");
  EXPECT_EQ(error_of_reading(folder.path() / "none.exr"),
            (folder.path() / "none.exr").string() + ": there is no such image file");
  EXPECT_EQ(error_of_reading(folder.path() / "folder.exr"),
            (folder.path() / "folder.exr").string() + ": is not a file, expected an image");
  EXPECT_EQ(error_of_reading(folder.path() / "notes.txt"),
            (folder.path() / "notes.txt").string() +
                ": no image format is known by this name; known are .exr .hdr .png .jpg .jpeg .bmp .tga "
                ".pfm .ppm .pgm");
}

TEST(ImageIo, ChannelsOfAPrefixAreSelectedByName) {
  const Image image = numbered_target(2, 1, {"variance.B", "R", "variance.R", "G", "B", "variance.G"});
  const Image variance = select_rgb(image, "variance.");
  EXPECT_EQ(variance.channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ(variance.at(1, 0, 0), image.at(1, 0, 2));
  EXPECT_EQ(variance.at(1, 0, 2), image.at(1, 0, 0));
  try {
    select_rgb(image, "path.");
    FAIL() << "no error";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "the image has no channel 'path.R'; it has variance.B, R, variance.R, G, B, variance.G");
  }
}
