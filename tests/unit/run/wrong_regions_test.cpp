// Where an image is wrong for certain, in words.
#include "run/wrong_regions.h"

#include "scene/load/load_scene.h"
#include "scene/seen_at.h"

#include <gtest/gtest.h>

using namespace orbs;

namespace {

// A wall of two materials fills the left and the right half of the view; a ball hides the middle, a lamp is
// above it.
scene::Scene walls() {
  return scene::load_scene_text("scene.json", R"({"format": "orbs-scene/1", "name": "s",
"camera": {"position": [0, 0, 4], "look_at": [0, 0, 0], "fov_y": 90, "width": 64, "height": 64},
"materials": [{"name": "red", "type": "lambert", "reflectance": [0.5, 0, 0]},
              {"name": "green", "type": "lambert", "reflectance": [0, 0.5, 0]}],
"meshes": [{"name": "wall", "positions": [-9, -9, 0, 0, -9, 0, 0, 9, 0, -9, 9, 0, 9, -9, 0, 9, 9, 0],
  "normals": [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1],
  "triangles": [0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2],
  "triangle_materials": [{"material": "red", "count": 2}, {"material": "green", "count": 2}]}],
"instances": [{"mesh": "wall", "name": "back wall", "matrix": [{"translate": [0, 0, 0]}]}],
"shapes": [{"name": "ball", "type": "sphere", "centre": [0, 0, 1], "radius": 0.5, "material": "red"}],
"lights": [{"name": "key", "type": "sphere", "radius": 0.3, "radiance": [1, 1, 1],
            "matrix": [{"translate": [0, 2, 1]}]}]})",
                                ".");
}

image::Image flat(float r, float g, float b) {
  auto image = image::make_image(64, 64, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    image.pixels[i] = r;
    image.pixels[i + 1] = g;
    image.pixels[i + 2] = b;
  }
  return image;
}

void scale(image::Image& image, std::array<int, 4> where, std::array<float, 3> factors) {
  for (int y = where[1]; y < where[3]; ++y)
    for (int x = where[0]; x < where[2]; ++x)
      for (int c = 0; c < 3; ++c)
        image.pixels[static_cast<std::size_t>((y * 64 + x) * 3 + c)] *=
            factors.at(static_cast<std::size_t>(c));
}

results::TargetRecord missed(const std::vector<std::pair<std::string, std::vector<double>>>& windows) {
  results::TargetRecord record;
  for (const auto& [name, where] : windows) {
    results::Measure measure;
    measure.name = name;
    measure.value = 0.1;
    measure.where = where;
    record.measures.push_back(measure);
    results::Check check;
    check.what = name;
    record.checks.push_back(check);
  }
  return record;
}

}  // namespace

TEST(SeenBy, MostOfThePoints) {
  const auto scene = walls();
  const auto seen = [&](const std::vector<scene::ImagePoint>& points) {
    return scene::seen_by_most(scene, {points}).front();
  };
  EXPECT_EQ(scene::seen_by_most(scene, {{{5, 30}, {6, 40}}, {{32, 32}}}),
            (std::vector<std::string>{"back wall (red)", "ball"}));
  EXPECT_EQ(seen({{5, 30}, {6, 40}}), "back wall (red)");
  EXPECT_EQ(seen({{60, 30}, {61, 40}, {5, 30}}), "back wall (green)");
  EXPECT_EQ(seen({{32, 32}}), "ball");
  EXPECT_EQ(seen({{32, 10.67}}), "light 'key'") << "(1 - 2 / 3) / 2 of 64 rows";
  EXPECT_EQ(seen({{60, 30}, {32, 32}, {5, 30}}), "") << "each is one of three";
}

TEST(WrongRegions, TheLargestIsFirstWithItsNameAndTheSignOfItsError) {
  const auto scene = walls();
  const auto reference = flat(0.5F, 0.5F, 0.5F);
  auto result = reference;
  scale(result, {0, 16, 16, 32}, {0.96F, 0.96F, 0.96F});
  scale(result, {56, 0, 64, 8}, {2.5F, 2.5F, 2.5F});
  auto record = missed({{"window_error_8px", {56, 0, 64, 8}}, {"window_error_16px", {0, 16, 16, 32}}});
  const auto regions = run::wrong_regions(record, result, reference, {}, &scene);
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].text, "the back wall (red), 4 % too dark");
  EXPECT_EQ(regions[0].where, (std::vector<double>{0, 16, 16, 32}));
  EXPECT_EQ(regions[1].text, "the back wall (green), 150 % too bright");
  EXPECT_EQ(run::wrong_regions(record, result, reference, {}, nullptr)[1].text,
            "the upper right, 150 % too bright");
  record.checks[0].decided = false;
  record.checks[1].passed = true;
  EXPECT_TRUE(run::wrong_regions(record, result, reference, {}, &scene).empty())
      << "neither is wrong for certain";
}

TEST(WrongRegions, OfAnotherColourAndBrightWhereItIsBlack) {
  const auto reference = flat(0.5F, 0.5F, 0);
  auto result = reference;
  scale(result, {24, 24, 40, 40}, {1.1F, 0.9F, 1});
  const auto record = missed({{"window_error_16px", {24, 24, 40, 40}}});
  EXPECT_EQ(run::wrong_regions(record, result, reference, {}, nullptr)[0].text,
            "the middle, of another colour: R +10 % G -10 % B +0 %");
  EXPECT_EQ(run::wrong_regions(record, result, flat(0, 0, 0), {}, nullptr)[0].text,
            "the middle, bright where it is black");
}

TEST(WrongRegions, LeaveOutMaskedPixels) {
  const auto reference = flat(0.5F, 0.5F, 0.5F);
  auto result = reference;
  scale(result, {0, 0, 16, 8}, {0, 0, 0});
  scale(result, {0, 8, 16, 16}, {1.2F, 1.2F, 1.2F});
  metrics::Mask mask;
  mask.rectangles.push_back({0, 0, 16, 8});
  const auto record = missed({{"window_error_16px", {0, 0, 16, 16}}});
  EXPECT_EQ(run::wrong_regions(record, result, reference, mask, nullptr)[0].text,
            "the upper left, 20 % too bright");
}
