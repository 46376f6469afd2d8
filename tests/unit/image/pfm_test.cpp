// Portable float maps (.pfm): a byte too many or too few in the header would shift all pixels.
#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "structure/source_files.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using structure::TestFolder;

std::string bytes_of(const std::vector<float>& values, bool is_little_endian = true) {
  std::string bytes(values.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  if (!is_little_endian)
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(float))
      std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                   bytes.begin() + static_cast<std::ptrdiff_t>(i + sizeof(float)));
  return bytes;
}

const std::vector<float> kColours{0, 1, 2, 3, 4, 5};

image::Image image_of(const std::string& bytes) {
  const TestFolder folder("pfm");
  write_file(folder.path() / "a.pfm", bytes);
  return image::read_image(folder.path() / "a.pfm");
}

void expect_refused(const std::string& bytes, const std::string& because) {
  try {
    image_of(bytes);
    FAIL() << "was read; expected: " << because;
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(because), std::string::npos) << e.what();
  }
}

TEST(Pfm, TheLastRowComesFirstInBothOrdersOfBytes) {
  const std::vector<float> expected{3, 4, 5, 0, 1, 2};
  EXPECT_EQ(image_of("PF\n1 2\n-1.0\n" + bytes_of(kColours)).pixels, expected);
  EXPECT_EQ(image_of("PF\n1 2\n1.0\n" + bytes_of(kColours, false)).pixels, expected);
  EXPECT_EQ(image_of("PF 1\t2  -1 " + bytes_of(kColours)).pixels, expected);
  const auto grey = image_of("Pf\n1 2\n-1.0\n" + bytes_of({7, 8}));
  EXPECT_EQ(grey.channels, std::vector<std::string>{"Y"});
  EXPECT_EQ(grey.pixels, (std::vector<float>{8, 7}));
}

TEST(Pfm, LineEndsThatWouldShiftThePixelsAreRefused) {
  expect_refused("PF\r\n1 2\r\n-1.0\r\n" + bytes_of(kColours),
                 "25 bytes follow its header of 1 x 2 px with 3 channels, expected 24; its header ends lines "
                 "with CR LF");
  expect_refused("PF\n1 2\n-1.0\n\n" + bytes_of(kColours), "25 bytes follow its header");
  expect_refused("PF\n1 2\n-1.0 \n" + bytes_of(kColours), "25 bytes follow its header");
}

TEST(Pfm, BytesThatAreMissingOrTooManyAreRefused) {
  const auto whole = "PF\n1 2\n-1.0\n" + bytes_of(kColours);
  expect_refused(whole + "x", "25 bytes follow its header");
  expect_refused(whole.substr(0, whole.size() - 1), "23 bytes follow its header");
  expect_refused("PF\n1 2\n-1.0\n" + bytes_of(kColours) + bytes_of(kColours), "48 bytes follow its header");
}

TEST(Pfm, HeadersThatAreNoneAreRefused) {
  for (const char* bad : {"P6\n1 1\n255\nabc", "PF\n1\n", "PF\n1 1\n", "PF\none 1\n-1.0\n", "PF\n1 1\nwide\n",
                          "PF\n# made\n1 1\n-1.0\n", "PF\n-1 1\n-1.0\n"})
    expect_refused(bad, "is no readable .pfm image");
  expect_refused("PF\n1 2\n-2.0\n" + bytes_of(kColours), "its scale is -2; expected -1 or 1");
}

}  // namespace
