// Radiance pictures (.hdr): their eight orders, what their headers ask for, and both ways of storing runs.
#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "structure/source_files.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;
using structure::TestFolder;

constexpr int kWidth = 3;
constexpr int kHeight = 2;

std::string pixel(int red, int green, int blue, int exponent) {
  return {static_cast<char>(red), static_cast<char>(green), static_cast<char>(blue),
          static_cast<char>(exponent)};
}

// Red says the column and green the row, from the upper left: with this exponent, in whole numbers.
std::string at(int x, int y) { return pixel(x + 1, y + 1, 200, 136); }

std::string file_of(const std::string& header, const std::string& resolution, const std::string& pixels) {
  return "#?RADIANCE\n" + header + "\n" + resolution + "\n" + pixels;
}

image::Image image_of(const std::string& bytes) {
  const TestFolder folder("radiance");
  write_file(folder.path() / "a.hdr", bytes);
  return image::read_image(folder.path() / "a.hdr");
}

std::string refusal_of(const std::string& bytes) {
  try {
    image_of(bytes);
  } catch (const InputError& e) {
    return e.what();
  }
  return "read";
}

void expect_refused(const std::string& bytes, const std::string& because) {
  const auto refusal = refusal_of(bytes);
  EXPECT_NE(refusal.find(because), std::string::npos) << refusal;
}

void expect_in_place(const image::Image& image, const std::string& which) {
  ASSERT_EQ(image.width, kWidth) << which;
  ASSERT_EQ(image.height, kHeight) << which;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      EXPECT_EQ(image.at(x, y, 0), static_cast<float>(x + 1)) << which << " at " << x << ", " << y;
      EXPECT_EQ(image.at(x, y, 1), static_cast<float>(y + 1)) << which << " at " << x << ", " << y;
    }
}

TEST(Radiance, AllEightOrdersAreReadAsTheResolutionSays) {
  for (const char sign_y : {'-', '+'})
    for (const char sign_x : {'-', '+'}) {
      const auto row = [&](int i) { return sign_y == '-' ? i : kHeight - 1 - i; };
      const auto column = [&](int i) { return sign_x == '+' ? i : kWidth - 1 - i; };
      std::string by_rows;
      for (int i = 0; i < kHeight; ++i)
        for (int k = 0; k < kWidth; ++k) by_rows += at(column(k), row(i));
      const auto rows = fmt::format("{}Y {} {}X {}", sign_y, kHeight, sign_x, kWidth);
      expect_in_place(image_of(file_of("", rows, by_rows)), rows);
      std::string by_columns;
      for (int i = 0; i < kWidth; ++i)
        for (int k = 0; k < kHeight; ++k) by_columns += at(column(i), row(k));
      const auto columns = fmt::format("{}X {} {}Y {}", sign_x, kWidth, sign_y, kHeight);
      expect_in_place(image_of(file_of("", columns, by_columns)), columns);
    }
}

TEST(Radiance, ExposuresAndCorrectionsAreDividedBy) {
  const auto one = pixel(64, 128, 255, 136);
  const auto plain = image_of(file_of("EXPOSURE=          1.0000000000000\n", "-Y 1 +X 1", one));
  EXPECT_EQ(plain.pixels, (std::vector<float>{64, 128, 255}));
  const auto twice = image_of(file_of("EXPOSURE=2\nVIEW= -vtv\nEXPOSURE = 0.25\n", "-Y 1 +X 1", one));
  EXPECT_EQ(twice.pixels, (std::vector<float>{128, 256, 510}));
  const auto colours = image_of(file_of("COLORCORR=1 2 4\nCOLORCORR= 1 1 0.5\n", "-Y 1 +X 1", one));
  EXPECT_EQ(colours.pixels, (std::vector<float>{64, 64, 127.5F}));
}

TEST(Radiance, HeadersOfRealProgramsAreRead) {
  const auto one = pixel(64, 128, 255, 136);
  // As of Photoshop, of Radiance's own tools and of stb_image_write, and with line ends of Windows.
  for (const std::string header :
       {"# Made with a painting program\r\nGAMMA=1\r\nPRIMARIES=0 0 0 0 0 0 0 0\r\n"
        "FORMAT=32-bit_rle_rgbe\r\n",
        "rpict -vp 1 2 3\n\tpfilt -1 -e 1\nSOFTWARE= RADIANCE 5.3\nVIEW= -vtv -vp 1 2 3\nCAPDATE= 2020:01:01 "
        "00:00:00\nPIXASPECT=1.000000\nFORMAT=32-bit_rle_rgbe\n",
        "# Written by stb_image_write.h\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=          1.0000000000000\n",
        "PRIMARIES= 0.640 0.330 0.300 0.600 0.150 0.060 0.3127 0.3290\n"}) {
    const auto image = image_of(file_of(header, "-Y 1 +X 1", one));
    EXPECT_EQ(image.pixels, (std::vector<float>{64, 128, 255})) << header;
  }
}

TEST(Radiance, WhatIsNoLinearRec709IsRefusedByName) {
  const auto one = pixel(64, 128, 255, 136);
  const auto with = [&](const std::string& line) { return file_of(line + "\n", "-Y 1 +X 1", one); };
  expect_refused(with("FORMAT=32-bit_rle_xyze"), "its FORMAT is 32-bit_rle_xyze");
  expect_refused(with("PRIMARIES=0.7347 0.2653 0 1 0.0001 -0.077 0.32168 0.33767"),
                 "its PRIMARIES (red, green, blue, white) are 0.7347");
  expect_refused(with("PRIMARIES=0.64 0.33"), "its PRIMARIES has 2 numbers; expected 8");
  expect_refused(with("GAMMA=2.2"), "its GAMMA is 2.2");
  expect_refused(with("PIXASPECT=1.5"), "its PIXASPECT is 1.5");
  expect_refused(with("EXPOSURE=0"), "its EXPOSURE is 0; expected a factor above 0");
  expect_refused(with("EXPOSURE=-2"), "its EXPOSURE is -2");
  expect_refused(with("EXPOSURE=bright"), "its EXPOSURE is 'bright'");
  expect_refused(with("COLORCORR=1 2"), "its COLORCORR has 2 numbers; expected 3");
}

TEST(Radiance, ResolutionsThatAreNoneAreRefused) {
  const auto one = pixel(64, 128, 255, 136);
  for (const char* bad : {"", "-Y 1", "1 1", "-Y 1 -Y 1", "-Z 1 +X 1", "-Y 0 +X 1", "-Y -1 +X 1",
                          "-Y 1 +X 1.5", "-Y 1 +X 1 +Z 1", "*Y 1 +X 1"})
    expect_refused(file_of("", bad, one), "its resolution is");
  expect_refused("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n", "its header does not end");
}

TEST(Radiance, BytesThatAreMissingOrTooManyAreRefused) {
  std::string pixels;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) pixels += at(x, y);
  expect_refused(file_of("", "-Y 2 +X 3", pixels + "x"), "1 bytes follow its last pixel");
  pixels.pop_back();
  expect_refused(file_of("", "-Y 2 +X 3", pixels), "the file ends before its last pixel");
}

TEST(Radiance, RunsOfBothKindsAreRead) {
  // Eight pixels: red in two runs of equal ones, green as eight different ones, blue and the exponent equal.
  const std::string runs = std::string("\x02\x02\x00\x08", 4) + "\x83\x05\x85\x07" +
                           std::string("\x08\x01\x02\x03\x04\x05\x06\x07\x08") + "\x88\x09" + "\x88\x88";
  const auto image = image_of(file_of("", "-Y 1 +X 8", runs));
  for (int x = 0; x < 8; ++x) {
    EXPECT_EQ(image.at(x, 0, 0), x < 3 ? 5.0F : 7.0F);
    EXPECT_EQ(image.at(x, 0, 1), static_cast<float>(x + 1));
    EXPECT_EQ(image.at(x, 0, 2), 9.0F);
  }
  // The older kind: a pixel, and that it comes 299 times more, which is 43 + 256.
  const auto old =
      image_of(file_of("", "-Y 1 +X 300", pixel(5, 6, 7, 136) + pixel(1, 1, 1, 43) + pixel(1, 1, 1, 1)));
  EXPECT_EQ(old.at(299, 0, 2), 7.0F);
  expect_refused(file_of("", "-Y 1 +X 8", std::string("\x02\x02\x00\x08\x89\x05", 6)),
                 "goes beyond its line");
  expect_refused(file_of("", "-Y 1 +X 2", pixel(1, 1, 1, 1)), "goes beyond its line");
}

}  // namespace
