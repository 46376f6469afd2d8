// orbs compare lists what two images hold beside their colour.
#include "cli/sandbox.h"
#include "image/image_io.h"

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
