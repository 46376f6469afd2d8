// The numbers that the documentation gives to whoever starts with a renderer are those of the references.
#include "image/image_io.h"
#include "structure/documentation.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = ORBS_SOURCE_DIR;

struct FirstScene {
  std::string name;
  std::string what;
  int x;  // of a pixel at which a mistake shows
  int y;  // from the top
};

// Each needs what those before it need, and one thing more.
const std::vector<FirstScene> kScenes{
    {"flat-field", "camera, emission", 3, 60},
    {"furnace-plane", "diffuse reflection, environment", 32, 32},
    {"glowing-panel", "a mesh that shines on a floor", 44, 40},
    {"rect-above", "a rectangular lamp", 20, 44},
    {"sphere-above", "a spherical lamp", 20, 44},
    {"oren-nayar-45", "rough diffuse reflection", 20, 44},
    {"mirror-ball", "a mirror", 32, 32},
    {"glass-plate", "glass", 8, 56},
};

std::string rgb_text(const std::array<double, 3>& rgb) {
  return fmt::format("{:.4f}, {:.4f}, {:.4f}", rgb[0], rgb[1], rgb[2]);
}

std::string row(const FirstScene& scene) {
  const auto image =
      image::select_rgb(image::read_image(kRoot / "data/references/known" / (scene.name + ".exr")), "");
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) sum[i % 3] += static_cast<double>(image.pixels[i]);
  std::array<double, 3> at{};
  for (std::size_t c = 0; c < 3; ++c) {
    sum[c] /= static_cast<double>(image.pixel_count());
    at[c] = static_cast<double>(image.at(scene.x, scene.y, c));
  }
  return fmt::format("| `{}` | {} | ({}, {}) | {} | {} |\n", scene.name, scene.what, scene.x, scene.y,
                     rgb_text(at), rgb_text(sum));
}

}  // namespace

TEST(FirstNumbers, AreThoseOfTheReferences) {
  std::string table =
      "| scene | what it needs | pixel | R, G, B there | mean of the image |\n|---|---|---|---|---|\n";
  for (const auto& scene : kScenes) table += row(scene);
  EXPECT_EQ(structure::check_generated_part(kRoot / "docs/use/renderers.md", "first numbers", table), "");
}
