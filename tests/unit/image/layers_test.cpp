#include "image/layers.h"

#include "image/image.h"
#include "image/image_io.h"
#include "structure/source_files.h"

#include <gtest/gtest.h>

using namespace orbs;
using image::Combination;

TEST(Layers, ChannelsAreThoseOfTheTable) {
  EXPECT_EQ(image::channels_of(*image::find_layer("normal")),
            (std::vector<std::string>{"normal.X", "normal.Y", "normal.Z"}));
  EXPECT_EQ(image::channels_of(*image::find_layer("instance")), (std::vector<std::string>{"instance.id"}));
  EXPECT_EQ(image::find_layer("beauty"), nullptr);
}

TEST(Layers, ColoursAndOthersAreNoLayersOfSurfaces) {
  for (const char* name : {"R", "variance.R", "S1.R", "path.D.R", "depth", "depth.", "depth.R", "normal.W"})
    EXPECT_FALSE(image::is_layer_channel(name)) << name;
  for (const char* name : {"depth.Z", "least.depth.Z", "most.uv.V", "coverage.A", "material.id"})
    EXPECT_TRUE(image::is_layer_channel(name)) << name;
}

TEST(Layers, NumbersAreNotAveragedAndRangesGrow) {
  EXPECT_EQ(image::combination_of("R"), Combination::Mean);
  EXPECT_EQ(image::combination_of("coverage.A"), Combination::Mean);
  EXPECT_EQ(image::combination_of("variance.G"), Combination::VarianceOfMean);
  EXPECT_EQ(image::combination_of("depth.Z"), Combination::CoveredMean);
  EXPECT_EQ(image::combination_of("least.depth.Z"), Combination::Least);
  EXPECT_EQ(image::combination_of("most.depth.Z"), Combination::Most);
  EXPECT_EQ(image::combination_of("object.id"), Combination::First);
}

// Four pixels, one of which shows nothing: it takes no part in depth and range.
TEST(Layers, AReducedImageHoldsWhatItsPixelsShow) {
  auto full =
      image::make_image(2, 2, {"coverage.A", "depth.Z", "least.depth.Z", "most.depth.Z", "object.id"});
  full.pixels = {1, 2, 1, 3, 7, 0.5F, 5, 4, 6, 7, 0, 0, 0, 0, 0, 1, 2, 2, 2, 9};
  const auto reduced = image::reduced_image(full, 2);
  EXPECT_EQ(reduced.pixels, (std::vector<float>{0.625F, 2.6F, 1, 6, 9}));
}

// 2049 is no half float.
TEST(Layers, TheirDigitsStayInAFileOfHalves) {
  const structure::TestFolder folder("layers");
  auto image = image::make_image(1, 1, {"R", "depth.Z", "object.id"});
  image.pixels = {2049, 2049, 2049};
  image::write_exr(image, folder.path() / "a.exr", image::Precision::Half);
  const auto read = image::read_image(folder.path() / "a.exr");
  const auto at = [&](const char* name) {
    return read.pixels[static_cast<std::size_t>(image::channel_index(read, name))];
  };
  EXPECT_EQ(at("R"), 2048);
  EXPECT_EQ(at("depth.Z"), 2049);
  EXPECT_EQ(at("object.id"), 2049);
}
