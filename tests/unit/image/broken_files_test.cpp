#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "structure/source_files.h"
#include "unit/image/png_bytes.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace orbs::image;
using orbs::InputError;
using orbs::image_test::png_bytes;
using orbs::image_test::png_chunk;
using orbs::structure::TestFolder;

// What reading these bytes under this name says: the error, or "read"; plus whatever landed on stderr.
std::string outcome_of(const TestFolder& folder, const std::string& name, const std::string& bytes) {
  const auto file = folder.path() / name;
  orbs::write_file(file, bytes);
  testing::internal::CaptureStderr();
  std::string outcome = "read";
  try {
    read_image(file);
  } catch (const InputError& e) {
    outcome = e.what();
  }
  const std::string printed = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(outcome == "read" || outcome.starts_with(file.string() + ": ")) << outcome;
  return outcome + (printed.empty() ? "" : "; printed: " + printed);
}

bool is_quiet_error(const std::string& outcome) {
  return outcome != "read" && outcome.find("; printed: ") == std::string::npos;
}

std::string exr_bytes(const TestFolder& folder, int width, int height) {
  Image image = make_image(width, height, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<float>(i * i % 101) * 0.37F;
  write_exr(image, folder.path() / "whole.exr");
  return orbs::read_file(folder.path() / "whole.exr");
}

// An EXR box2i attribute is its name, its type's name, the size 16 and xMin, yMin, xMax, yMax in
// little-endian.
std::string with_box(std::string exr, const std::string& name, std::vector<std::int32_t> box) {
  const std::string key = name + '\0' + "box2i" + '\0';
  const auto at = exr.find(key);
  EXPECT_NE(at, std::string::npos);
  std::memcpy(&exr[at + key.size() + 4], box.data(), 16);
  return exr;
}

std::string with_size(const std::string& exr, std::int32_t width, std::int32_t height) {
  const std::vector<std::int32_t> box{0, 0, width - 1, height - 1};
  return with_box(with_box(exr, "dataWindow", box), "displayWindow", box);
}

// The list of EXR channels has each name, a zero and the type: 2 is float, 0 a 32-bit integer.
std::string with_integers(std::string exr, const std::string& channel) {
  const auto at = exr.find(channel + std::string("\0\2\0\0\0", 5));
  EXPECT_NE(at, std::string::npos) << channel;
  exr[at + channel.size() + 1] = '\0';
  return exr;
}

std::string exr_of(const TestFolder& folder, const std::vector<std::string>& channels) {
  write_exr(make_image(2, 2, channels), folder.path() / "floats.exr");
  return orbs::read_file(folder.path() / "floats.exr");
}

}  // namespace

TEST(ImageBrokenFiles, AnEmptyFileIsNoImage) {
  const TestFolder folder("broken-empty");
  for (const char* name : {"a.exr", "a.png", "a.jpg", "a.hdr", "a.bmp", "a.tga", "a.pfm", "a.ppm"})
    EXPECT_EQ(outcome_of(folder, name, ""),
              (folder.path() / name).string() + ": is empty, expected an image");
}

TEST(ImageBrokenFiles, TextIsNoImageUnderAnyName) {
  const TestFolder folder("broken-text");
  const std::string text = "Rendering failed: out of memory\n" + std::string(2000, 'x');
  for (const char* name : {"a.exr", "a.png", "a.jpg", "a.hdr", "a.bmp", "a.tga", "a.pfm", "a.ppm"}) {
    const auto outcome = outcome_of(folder, name, text);
    EXPECT_TRUE(is_quiet_error(outcome)) << name << ": " << outcome;
  }
}

TEST(ImageBrokenFiles, AnImageUnderAnotherFormatsNameIsRefused) {
  const TestFolder folder("broken-name");
  const std::string png = png_bytes(1, 1, 8, 0, std::string("\0\x40", 2));
  const auto outcome = outcome_of(folder, "a.exr", png);
  EXPECT_TRUE(is_quiet_error(outcome)) << outcome;
  EXPECT_NE(outcome.find("is no readable .exr image"), std::string::npos) << outcome;
}

TEST(ImageBrokenFiles, AnExrTornAnywhereIsRefused) {
  const TestFolder folder("broken-torn");
  const std::string whole = exr_bytes(folder, 24, 40);
  ASSERT_EQ(outcome_of(folder, "whole.exr", whole), "read");
  for (std::size_t length = 1; length < whole.size(); length += 61) {
    const auto outcome = outcome_of(folder, "a.exr", whole.substr(0, length));
    EXPECT_TRUE(is_quiet_error(outcome))
        << "first " << length << " of " << whole.size() << " bytes: " << outcome;
  }
}

TEST(ImageBrokenFiles, AnExrWithFlippedBytesIsReadOrRefusedButNeverCrashes) {
  const TestFolder folder("broken-flipped");
  const std::string whole = exr_bytes(folder, 24, 40);
  for (std::size_t at = 0; at < whole.size(); at += 13) {
    std::string flipped = whole;
    flipped[at] = static_cast<char>(~flipped[at]);
    const auto outcome = outcome_of(folder, "a.exr", flipped);
    EXPECT_TRUE(outcome == "read" || is_quiet_error(outcome)) << "byte " << at << ": " << outcome;
  }
}

TEST(ImageBrokenFiles, AHeaderThatClaimsAnImpossibleSizeIsRefusedBeforeMemoryIsAskedFor) {
  const TestFolder folder("broken-huge");
  EXPECT_EQ(outcome_of(folder, "a.pfm", "PF\n40000 40000\n-1.0\n0123456789ab"),
            (folder.path() / "a.pfm").string() +
                ": the header says 40000 x 40000 px with 3 channels; at most 536870912 values are read");
  const std::string whole = exr_bytes(folder, 4, 4);
  for (const auto& [width, height] :
       {std::pair{0, 0}, std::pair{-5, -5}, std::pair{2000000000, 2000000000}, std::pair{200000000, 4}}) {
    const auto outcome = outcome_of(folder, "a.exr", with_size(whole, width, height));
    EXPECT_TRUE(is_quiet_error(outcome)) << width << " x " << height << ": " << outcome;
  }
}

TEST(ImageBrokenFiles, ACroppedExrIsRefusedBecauseItsPixelsWouldBeShifted) {
  const TestFolder folder("broken-cropped");
  const auto outcome =
      outcome_of(folder, "a.exr", with_box(exr_bytes(folder, 4, 4), "displayWindow", {-1, 0, 6, 3}));
  EXPECT_NE(outcome.find("the stored pixels (4 x 4 at 0, 0) are not the whole image (8 x 4 at -1, 0)"),
            std::string::npos)
      << outcome;
}

TEST(ImageBrokenFiles, APngTornAnywhereOrWithAFlippedByteIsRefusedQuietly) {
  const TestFolder folder("broken-png");
  Image image = make_image(9, 7, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<float>(i % 17) / 17.0F;
  write_png(image, folder.path() / "whole.png");
  const std::string whole = orbs::read_file(folder.path() / "whole.png");
  for (std::size_t at = 0; at < whole.size(); at += 3) {
    const auto torn = outcome_of(folder, "a.png", whole.substr(0, at));
    EXPECT_TRUE(is_quiet_error(torn)) << "first " << at << " bytes: " << torn;
    std::string flipped = whole;
    flipped[at] = static_cast<char>(~flipped[at]);
    const auto outcome = outcome_of(folder, "a.png", flipped);
    EXPECT_TRUE(is_quiet_error(outcome)) << "byte " << at << ": " << outcome;
  }
}

TEST(ImageBrokenFiles, APngWithAnImpossibleHeaderIsRefusedQuietly) {
  const TestFolder folder("broken-png-header");
  const std::string row("\0\x40", 2);
  const auto place = (folder.path() / "a.png").string() + ": is no readable .png image: ";
  EXPECT_EQ(outcome_of(folder, "a.png", png_bytes(2000000000, 2000000000, 8, 0, row)),
            place + "Image height exceeds user limit in IHDR; Invalid IHDR data");
  EXPECT_EQ(outcome_of(folder, "a.png", png_bytes(0, 1, 8, 0, row)),
            place + "Image width is zero in IHDR; Invalid IHDR data");
  EXPECT_EQ(outcome_of(folder, "a.png", png_bytes(1, 1, 7, 0, row)),
            place + "Invalid bit depth in IHDR; Invalid IHDR data");
}

// A chunk of two gigabytes in a file of a hundred bytes: libpng would ask for them.
TEST(ImageBrokenFiles, APngThatEndsInsideAChunkIsRefusedBeforeMemoryIsAskedFor) {
  const TestFolder folder("broken-png-lengths");
  const std::string whole = png_bytes(1, 1, 8, 0, std::string("\0\x40", 2), png_chunk("tEXt", "a"));
  auto longer = whole;
  longer[longer.find("tEXt") - 4] = '\x7f';
  EXPECT_EQ(outcome_of(folder, "a.png", longer),
            (folder.path() / "a.png").string() + ": the file ends inside a PNG chunk");
  EXPECT_EQ(outcome_of(folder, "a.png", whole.substr(0, whole.find("IEND") - 4)),
            (folder.path() / "a.png").string() + ": the PNG has no end");
}

TEST(ImageBrokenFiles, APngWithoutPixelsIsRefused) {
  const TestFolder folder("broken-png-empty");
  const std::string whole = png_bytes(1, 1, 8, 0, std::string("\0\x40", 2));
  const auto pixels = whole.find("IDAT") - 4;
  const auto end = whole.find("IEND") - 4;
  EXPECT_EQ(outcome_of(folder, "a.png", whole.substr(0, pixels) + whole.substr(end)),
            (folder.path() / "a.png").string() + ": is no readable .png image: IEND: out of place");
}

TEST(ImageBrokenFiles, APngWhosePaletteOrCriticalChunksAreWrongIsRefusedQuietly) {
  const TestFolder folder("broken-png-chunks");
  const std::string row("\0\x00", 2);
  const std::string palette = png_chunk("PLTE", "abc");
  const auto place = (folder.path() / "a.png").string() + ": is no readable .png image: ";
  EXPECT_EQ(outcome_of(folder, "a.png", png_bytes(1, 1, 8, 3, row, palette)), "read");
  EXPECT_EQ(outcome_of(folder, "a.png", png_bytes(1, 1, 8, 3, row)),
            place + "IDAT: Missing PLTE before IDAT");
  EXPECT_EQ(outcome_of(folder, "a.png", png_bytes(1, 1, 8, 3, row, palette + palette)),
            place + "PLTE: duplicate");
  EXPECT_EQ(outcome_of(folder, "a.png", png_bytes(1, 1, 8, 3, row, png_chunk("PLTE", "abcd"))),
            place + "PLTE: invalid");
  EXPECT_EQ(outcome_of(folder, "a.png", png_bytes(1, 1, 8, 0, row, png_chunk("ABCD", "x"))),
            place + "ABCD: unhandled critical chunk");
}

TEST(ImageBrokenFiles, AJpegWithoutItsEndIsRefused) {
  const TestFolder folder("broken-jpeg");
  // Start of image, start of scan and entropy-coded data, then nothing: as much as the check looks at.
  const auto outcome =
      outcome_of(folder, "a.jpg", std::string("\xff\xd8\xff\xda\x00\x08\x12\x34\xff\x00\x56", 11));
  EXPECT_EQ(outcome, (folder.path() / "a.jpg").string() + ": is no whole JPEG: the end marker is missing");
}

TEST(ImageBrokenFiles, AnExrWhoseColoursAreIntegersIsRefused) {
  const TestFolder folder("broken-integers");
  const auto colours = exr_of(folder, {"R", "G", "B", "variance.G", "id"});
  for (const char* channel : {"R", "G", "B", "variance.G"})
    EXPECT_EQ(outcome_of(folder, "a.exr", with_integers(colours, channel)),
              fmt::format("{}: the EXR channel '{}' holds integers, expected half or float",
                          (folder.path() / "a.exr").string(), channel));
  EXPECT_NE(outcome_of(folder, "a.exr", with_integers(exr_of(folder, {"mask"}), "mask")), "read");
}

TEST(ImageBrokenFiles, IntegersBesideTheColoursOfAnExrAreHarmless) {
  const TestFolder folder("broken-labels");
  const auto image = exr_of(folder, {"R", "G", "B", "id"});
  EXPECT_EQ(outcome_of(folder, "a.exr", with_integers(image, "id")), "read");
}

// Without a byte on the disk: the file is one hole. Readers that take a file as a whole would ask for as
// much memory.
TEST(ImageBrokenFiles, AFileThatIsLargerThanAnyImageIsNotRead) {
  const TestFolder folder("broken-hole");
  constexpr std::uintmax_t kBytes = 10'000'000'000;
  for (const char* name : {"a.pfm", "a.ppm", "a.exr", "a.png"}) {
    const auto file = folder.path() / name;
    orbs::write_file(file, "PF\n100 100\n-1.0\n");
    std::filesystem::resize_file(file, kBytes);
    try {
      read_image(file);
      FAIL() << "was read";
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find("has 10000000000 bytes; no image that is read has more than"),
                std::string::npos)
          << e.what();
    }
  }
}

// An attribute of an EXR header: its name, its type's name, the length of its value in four bytes, the value.
std::string with_attribute(std::string exr,
                           const std::string& name,
                           const std::string& type,
                           const std::vector<float>& values) {
  std::string attribute = name + '\0' + type + '\0';
  const auto length = static_cast<std::uint32_t>(values.size() * sizeof(float));
  attribute.append(reinterpret_cast<const char*>(&length), sizeof length);
  attribute.append(reinterpret_cast<const char*>(values.data()), length);
  return exr.insert(8, attribute);  // behind magic and version
}

TEST(ImageBrokenFiles, ColoursOfOtherPrimariesAreRefusedByName) {
  const TestFolder folder("image-primaries");
  const auto exr = exr_bytes(folder, 4, 4);
  const std::string type = "chromaticities";
  const auto aces = outcome_of(
      folder, "aces.exr",
      with_attribute(exr, type, type, {0.7347F, 0.2653F, 0, 1, 0.0001F, -0.077F, 0.32168F, 0.33767F}));
  EXPECT_NE(aces.find("expected those of Rec.709"), std::string::npos) << aces;
  EXPECT_NE(aces.find("0.7347"), std::string::npos) << aces;
  const auto rec709 =
      outcome_of(folder, "rec709.exr",
                 with_attribute(exr, type, type, {0.64F, 0.33F, 0.3F, 0.6F, 0.15F, 0.06F, 0.3127F, 0.329F}));
  EXPECT_EQ(rec709.find("chromaticities"), std::string::npos) << rec709;
}

TEST(ImageBrokenFiles, PixelsThatAreNotSquareAreRefused) {
  const TestFolder folder("image-aspect");
  auto exr = exr_bytes(folder, 4, 4);
  const std::string key = std::string("pixelAspectRatio") + '\0' + "float" + '\0';
  const auto at = exr.find(key);
  ASSERT_NE(at, std::string::npos);
  const float two = 2;
  std::memcpy(&exr[at + key.size() + 4], &two, sizeof two);
  const auto said = outcome_of(folder, "wide.exr", exr);
  EXPECT_NE(said.find("pixelAspectRatio is 2, expected square pixels"), std::string::npos) << said;
}
