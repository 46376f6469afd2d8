// orbs compare lists what two images hold beside their colour.
#include "cli/sandbox.h"
#include "image/image_io.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::contains;
using cli_tests::Sandbox;

namespace {

void write_at_depth(const Sandbox& sandbox, const std::string& file, float depth_m, const std::string& more) {
  auto image = image::make_image(8, 8, {"R", "G", "B", "depth.Z", "least.depth.Z", more});
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = i % 6 < 3 ? 0.5F : 2;
  image.at(3, 4, 3) = depth_m;
  image::write_exr(image, sandbox.folder() / file);
}

void write_layers(const Sandbox& sandbox,
                  const std::string& file,
                  const std::vector<std::string>& channels,
                  const std::vector<float>& values) {
  auto image = image::make_image(8, 8, channels);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = values[i % values.size()];
  image::write_exr(image, sandbox.folder() / file);
}

}  // namespace

TEST(CompareChannels, ThoseBesideTheColourAreListed) {
  const Sandbox sandbox;
  write_at_depth(sandbox, "a.exr", 5, "mine");
  write_at_depth(sandbox, "b.exr", 2, "yours");
  const auto answer = sandbox.orbs({"compare", "a.exr", "b.exr"});
  EXPECT_EQ(answer.status, 0);
  EXPECT_TRUE(contains(answer.text,
                       "depth.Z                    2.046875              2              3  (3, 4)         1"))
      << answer.text;
  EXPECT_TRUE(contains(answer.text, "only in the image: mine")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "only in the reference: yours")) << answer.text;
  EXPECT_FALSE(contains(answer.text, "least.depth.Z")) << answer.text;
  EXPECT_TRUE(contains(sandbox.orbs({"compare", "a.exr", "b.exr", "--all"}).text, "least.depth.Z"));
  EXPECT_TRUE(contains(sandbox.orbs({"compare", "a.exr", "b.exr", "--json"}).text, R"("largest": 3)"));
}

TEST(CompareChannels, ALayerCanBeTheTolerance) {
  const Sandbox sandbox;
  write_at_depth(sandbox, "a.exr", 5, "mine");
  write_at_depth(sandbox, "b.exr", 2, "mine");
  EXPECT_EQ(sandbox.orbs({"compare", "a.exr", "b.exr", "--metric", "layer_pixels", "--max", "0"}).status, 1);
  EXPECT_EQ(sandbox.orbs({"compare", "a.exr", "a.exr", "--metric", "layer_pixels", "--max", "0"}).status, 0);
}

// As Blender, OpenImageIO and others write them: the only colours are those that are meant.
TEST(CompareChannels, LayersAreComparedWhereTheImagesSayWhich) {
  const Sandbox sandbox;
  write_layers(sandbox, "plain.exr", {"R", "G", "B"}, {0.25F, 0.5F, 1});
  write_layers(sandbox, "rgba.exr", {"rgba.R", "rgba.G", "rgba.B", "rgba.A"}, {0.25F, 0.5F, 1, 1});
  write_layers(sandbox, "blender.exr",
               {"ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B", "ViewLayer.DiffDir.R",
                "ViewLayer.DiffDir.G", "ViewLayer.DiffDir.B", "ViewLayer.Depth.Z"},
               {0.25F, 0.5F, 1, 7, 7, 7, 3});
  for (const char* file : {"rgba.exr", "blender.exr"})
    for (const char* other : {"plain.exr", "rgba.exr", "blender.exr"}) {
      const auto answer = sandbox.orbs({"compare", file, other, "--metric", "mse", "--max", "0"});
      EXPECT_EQ(answer.status, 0) << file << " " << other << answer.text;
      EXPECT_TRUE(contains(answer.text, std::string("of ") + file + " the channels of '")) << answer.text;
    }
}

TEST(CompareChannels, AWordSaysWhichLayerOrChannel) {
  const Sandbox sandbox;
  write_layers(sandbox, "a.exr", {"one.R", "one.G", "one.B", "two.R", "two.G", "two.B", "Depth.Z"},
               {1, 2, 3, 4, 5, 6, 7});
  write_layers(sandbox, "b.exr", {"R", "G", "B"}, {4, 5, 6});
  write_layers(sandbox, "depth.exr", {"Depth.Z"}, {7});
  const auto undecided = sandbox.orbs({"compare", "a.exr", "b.exr"});
  EXPECT_EQ(undecided.status, 2);
  EXPECT_TRUE(contains(undecided.text, "--channels NAME says which are its colours")) << undecided.text;
  const auto status = [&](const char* other, const char* name) {
    return sandbox.orbs({"compare", "a.exr", other, "--channels", name, "--metric", "mse", "--max", "0"})
        .status;
  };
  EXPECT_EQ(status("b.exr", "two"), 0);
  EXPECT_EQ(status("b.exr", "one"), 1);
  EXPECT_EQ(status("depth.exr", "Depth.Z"), 0);
  EXPECT_EQ(status("b.exr", "three"), 2);
}

TEST(CompareChannels, GreyImagesAreCompared) {
  const Sandbox sandbox;
  write_layers(sandbox, "grey.exr", {"Y"}, {0.25F});
  write_layers(sandbox, "plain.exr", {"R", "G", "B"}, {0.25F});
  for (const char* other : {"grey.exr", "plain.exr"}) {
    const auto answer = sandbox.orbs({"compare", "grey.exr", other, "--metric", "mse", "--max", "0"});
    EXPECT_EQ(answer.status, 0) << answer.text;
  }
}
