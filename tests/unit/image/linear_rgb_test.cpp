
#include "base/error.h"
#include "image/image_io.h"
#include "structure/source_files.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs::image;
using orbs::structure::TestFolder;

// One pixel whose channels hold 0.25, 0.5, 0.75 in the order given.
std::filesystem::path image_of(const TestFolder& folder, const std::vector<std::string>& channels) {
  auto image = make_image(1, 1, channels);
  for (std::size_t c = 0; c < channels.size(); ++c) image.pixels[c] = 0.25F * static_cast<float>(c + 1);
  write_exr(image, folder.path() / "a.exr");
  return folder.path() / "a.exr";
}

std::string error_for(const std::vector<std::string>& channels) {
  const TestFolder folder("linear-rgb-refused");
  const auto file = image_of(folder, channels);
  try {
    read_linear_rgb(file);
  } catch (const orbs::InputError& e) {
    const std::string text = e.what();
    EXPECT_TRUE(text.starts_with(file.string() + ": ")) << text;
    return text.substr(std::min(text.size(), file.string().size() + 2));
  }
  return "no error";
}

}  // namespace

TEST(LinearRgb, OneColourWithOrWithoutAlphaIsGrey) {
  const TestFolder folder("linear-rgb-grey");
  EXPECT_EQ(read_linear_rgb(image_of(folder, {"Y"})).pixels, (std::vector{0.25F, 0.25F, 0.25F}));
  EXPECT_EQ(read_linear_rgb(image_of(folder, {"Y", "A"})).pixels, (std::vector{0.25F, 0.25F, 0.25F}));
  EXPECT_EQ(read_linear_rgb(image_of(folder, {"R", "G", "B"})).pixels, (std::vector{0.25F, 0.5F, 0.75F}));
}

TEST(LinearRgb, WhatStandsBesideTheColoursIsLeftOut) {
  const TestFolder folder("linear-rgb-beside");
  for (const auto& channels : {std::vector<std::string>{"R", "G", "B", "A"},
                               {"R", "G", "B", "Z"},
                               {"R", "G", "B", "variance.R", "X"}})
    EXPECT_EQ(read_linear_rgb(image_of(folder, channels)).pixels, (std::vector{0.25F, 0.5F, 0.75F}));
  EXPECT_EQ(read_linear_rgb(image_of(folder, {"Y", "variance.Y"})).pixels,
            (std::vector{0.25F, 0.25F, 0.25F}));
}

TEST(LinearRgb, ChannelsThatAreNoColoursAreNamed) {
  const std::string expected = "; expected R, G and B, or Y alone, and alpha as A";
  EXPECT_EQ(error_for({"R", "G"}), "has the channels R, G" + expected);
  EXPECT_EQ(error_for({"R", "G", "A"}), "has the channels R, G, A" + expected);
  EXPECT_EQ(error_for({"Z", "N.X", "N.Y"}), "has the channels Z, N.X, N.Y" + expected);
  EXPECT_EQ(error_for({"X", "Y", "Z"}), "has the channels X, Y, Z" + expected);
  EXPECT_EQ(error_for({"Y", "RY", "BY"}), "has the channels Y, BY, RY" + expected);
  EXPECT_EQ(error_for({"Z"}), "has the channels Z" + expected);
  EXPECT_EQ(error_for({"diffuse.R", "diffuse.G", "diffuse.B"}),
            "has the channels diffuse.R, diffuse.G, diffuse.B" + expected);
}
