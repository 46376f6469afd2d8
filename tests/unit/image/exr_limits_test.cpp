// Headers of EXR files that are larger than an image needs: OpenEXR keeps all of them in memory, several
// times.
#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "structure/source_files.h"

#include <cstdint>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;
using structure::TestFolder;

std::string word(std::size_t number) {
  std::string bytes;
  for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xffU);
  return bytes;
}

std::string attribute(const std::string& name, const std::string& type, const std::string& value) {
  return name + '\0' + type + '\0' + word(value.size()) + value;
}

// Behind magic and version.
std::string with_attributes(const TestFolder& folder, const std::string& attributes) {
  image::write_exr(image::make_image(4, 4, {"R", "G", "B"}), folder.path() / "plain.exr");
  return read_file(folder.path() / "plain.exr").insert(8, attributes);
}

std::string refusal_of(const TestFolder& folder, const std::string& attributes) {
  write_file(folder.path() / "a.exr", with_attributes(folder, attributes));
  try {
    image::read_header(folder.path() / "a.exr");
  } catch (const InputError& e) {
    return e.what();
  }
  return "read";
}

void expect_refused(const std::string& refusal, const std::string& because) {
  EXPECT_NE(refusal.find(because), std::string::npos) << refusal;
}

TEST(ExrLimits, AHeaderOfManyMegabytesIsRefused) {
  const TestFolder folder("exr-large-header");
  const std::string text(std::size_t{20} << 20, 'x');
  expect_refused(refusal_of(folder, attribute("manifest", "string", text)),
                 "has more than 16 MiB or 10000 attributes");
  const std::string part(std::size_t{3} << 20, 'x');
  std::string parts;
  for (int i = 0; i < 7; ++i) parts += attribute(fmt::format("part{}", i), "string", part);
  expect_refused(refusal_of(folder, parts), "has more than 16 MiB or 10000 attributes");
}

TEST(ExrLimits, ManySmallAttributesAreRefused) {
  const TestFolder folder("exr-many-attributes");
  std::string many;
  for (int i = 0; i < 10001; ++i) many += attribute(fmt::format("a{}", i), "int", word(1));
  expect_refused(refusal_of(folder, many), "has more than 16 MiB or 10000 attributes");
}

TEST(ExrLimits, LongListsAreRefused) {
  const TestFolder folder("exr-long-lists");
  std::string texts;
  std::string channels;
  for (int i = 0; i < 4097; ++i) {
    texts += word(0);
    channels += fmt::format("{:05}", i) + '\0' + word(1) + word(0) + word(1) + word(1);
  }
  expect_refused(refusal_of(folder, attribute("texts", "stringvector", texts)), "more than 4096 texts");
  expect_refused(refusal_of(folder, attribute("more", "chlist", channels + '\0')), "more than 4096 channels");
}

TEST(ExrLimits, AManifestOfMegabytesIsRead) {
  const TestFolder folder("exr-manifest");
  const std::string text(std::size_t{4} << 20, 'x');
  EXPECT_EQ(refusal_of(folder, attribute("manifest", "string", text)), "read");
}

}  // namespace
