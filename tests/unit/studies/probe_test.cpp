// Painted images of a probe: the right one, and what comes of a wrong camera, a lost or exchanged object.
#include "base/files.h"
#include "scene/camera_frame.h"
#include "scene/geometry/generators.h"
#include "scene/load/load_scene.h"
#include "scene/lower/lower.h"
#include "studies/probe/compare.h"
#include "studies/probe/layers_pass.h"
#include "studies/probe/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

scene::Scene two_boxes() {
  return scene::load_scene_text("boxes.json", R"({
    "format": "orbs-scene/1", "name": "boxes",
    "camera": { "position": [0, 1, 6], "look_at": [0, 0, 0], "fov_y": 40, "width": 256, "height": 192 },
    "materials": [ { "name": "a", "type": "lambert", "reflectance": [0.5, 0.5, 0.5] },
                   { "name": "b", "type": "lambert", "reflectance": [0.5, 0.5, 0.5] } ],
    "meshes": [ { "name": "box", "generator": "cube", "half_size": 0.7, "material": "a" } ],
    "instances": [ { "name": "left", "mesh": "box", "matrix": [1,0,0,-1.2, 0,1,0,0, 0,0,1,0, 0,0,0,1] },
                   { "name": "right", "mesh": "box", "matrix": [1,0,0,1.2, 0,1,0,0, 0,0,1,0, 0,0,0,1],
                     "remap": ["a", "b"] } ],
    "lights": [ { "name": "lamp", "type": "sphere", "radius": 0.3, "radiance": [1, 1, 1],
                  "matrix": [1,0,0,0, 0,1,0,1, 0,0,1,0, 0,0,0,1] } ]
  })",
                                ".");
}

// What a renderer with a box filter would make of it.
image::Image painted(const studies::ProbeScene& probe, const scene::Scene& nearest) {
  constexpr studies::VisibilityGrid kGrid{8, -1.0 / 16};
  auto image = image::make_image(nearest.camera.width_px, nearest.camera.height_px, {"R", "G", "B"});
  const auto surfaces = studies::primary_visibility(nearest, kGrid, 1);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i].object == studies::kNoObject) continue;
    const Vec3d c = probe.objects[static_cast<std::size_t>(surfaces[i].object)].radiance / 64.0;
    float* const pixel = &image.pixels[i / 64 * 3];
    pixel[0] += static_cast<float>(c.x);
    pixel[1] += static_cast<float>(c.y);
    pixel[2] += static_cast<float>(c.z);
  }
  return image;
}

studies::ProbeFindings findings(const studies::ProbeScene& probe, const image::Image& image) {
  return studies::compare_id_pass(probe, studies::primary_visibility(probe.scene, {}, 1), image);
}

}  // namespace

TEST(Probe, GivesEveryMaterialOfEveryInstanceAndEveryLightItsColour) {
  const auto probe = studies::make_id_pass(two_boxes(), 128);
  ASSERT_EQ(probe.objects.size(), 3U);
  EXPECT_EQ(probe.objects[0].name, "instance 'left', material 'a'");
  EXPECT_EQ(probe.objects[1].name, "instance 'right', material 'b'");
  EXPECT_EQ(probe.objects[2].name, "light 'lamp'");
  EXPECT_NE(probe.objects[0].radiance, probe.objects[1].radiance);
  EXPECT_EQ(probe.scene.camera.width_px, 128);
  EXPECT_EQ(probe.scene.camera.height_px, 96);
}

TEST(Probe, TheRightImageHasNoMismatch) {
  const auto probe = studies::make_id_pass(two_boxes(), 128);
  const auto found = findings(probe, painted(probe, probe.scene));
  EXPECT_TRUE(found.mismatches.empty());
  EXPECT_GT(found.compared, 128 * 96 * 3 / 4);
}

TEST(Probe, ACameraThatIsOffByHalfAPixelIsSeen) {
  const auto probe = studies::make_id_pass(two_boxes(), 128);
  auto shifted = probe.scene;
  const double half_pixel_m = 0.5 * 2 * 6.08 * 0.364 / 96;  // at the boxes' distance
  shifted.camera.position_m.x += half_pixel_m;
  shifted.camera.look_at_m.x += half_pixel_m;
  const auto found = findings(probe, painted(probe, shifted));
  ASSERT_FALSE(found.mismatches.empty());
  EXPECT_GT(found.mismatches[0].pixels, 10);
}

TEST(Probe, ASinglePixelThatShowsAMixtureIsACrack) {
  const auto probe = studies::make_id_pass(two_boxes(), 128);
  auto image = painted(probe, probe.scene);
  image.at(5, 5, 1) += 0.01F;
  const auto found = findings(probe, image);
  EXPECT_TRUE(found.mismatches.empty());
  EXPECT_EQ(found.cracks, 1);
  for (int x = 0; x < 5; ++x) image.at(x, 5, 1) += 0.01F;
  EXPECT_EQ(findings(probe, image).mismatches.size(), 1U);
}

namespace {

// Adds noise of this standard deviation, evenly distributed, and its variance.
image::Image with_noise(const image::Image& image, double deviation) {
  auto noisy =
      image::make_image(image.width, image.height, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-std::sqrt(3.0) * deviation, std::sqrt(3.0) * deviation);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    noisy.pixels[i / 3 * 6 + i % 3] = image.pixels[i] + static_cast<float>(noise(random));
    noisy.pixels[i / 3 * 6 + 3 + i % 3] = static_cast<float>(deviation * deviation);
  }
  return noisy;
}

}  // namespace

TEST(Probe, NoiseIsNoMismatchButWhatIsMovedIs) {
  const auto probe = studies::make_id_pass(two_boxes(), 128);
  const auto image = painted(probe, probe.scene);
  EXPECT_TRUE(findings(probe, with_noise(image, 0.005)).mismatches.empty());
  auto without = probe.scene;
  without.instances.pop_back();
  const auto found = findings(probe, with_noise(painted(probe, without), 0.005));
  ASSERT_EQ(found.mismatches.size(), 1U);
  EXPECT_EQ(found.mismatches[0].instead, "nothing");
}

TEST(Probe, TooMuchNoiseAsksForSamples) {
  const auto probe = studies::make_id_pass(two_boxes(), 128);
  const auto found = findings(probe, with_noise(painted(probe, probe.scene), 0.1));
  EXPECT_TRUE(found.mismatches.empty());
  ASSERT_TRUE(found.needed_samples);
  EXPECT_GT(*found.needed_samples, 4);
  EXPECT_LT(*found.needed_samples, 1000);
}

TEST(Probe, AnObjectThatIsNotThereIsNamed) {
  const auto probe = studies::make_id_pass(two_boxes(), 128);
  auto without = probe.scene;
  without.instances.pop_back();
  const auto found = findings(probe, painted(probe, without));
  ASSERT_EQ(found.mismatches.size(), 1U);
  EXPECT_EQ(found.mismatches[0].object, 1);
  EXPECT_EQ(found.mismatches[0].instead, "nothing");
}

TEST(Probe, ARemapListThatIsNotAppliedIsNamed) {
  const auto probe = studies::make_id_pass(two_boxes(), 128);
  auto ignored = probe.scene;
  for (auto& instance : ignored.instances) instance.remap.clear();
  const auto found = findings(probe, painted(probe, ignored));
  ASSERT_EQ(found.mismatches.size(), 1U);
  EXPECT_EQ(found.mismatches[0].object, 1);
  EXPECT_EQ(found.mismatches[0].instead, "instance 'left', material 'a'");
}

TEST(Probe, IsTheSameForARendererThatGetsItLowered) {
  const auto probe = studies::make_id_pass(two_boxes(), 128);
  const auto lowered = scene::lower(probe.scene, {"G1", "G2", "L1", "L2", "L3", "M1", "M2"});
  ASSERT_TRUE(std::holds_alternative<scene::Scene>(lowered)) << std::get<std::string>(lowered);
  EXPECT_TRUE(findings(probe, painted(probe, std::get<scene::Scene>(lowered))).mismatches.empty());
}

namespace {

image::Image painted_coordinates(const scene::Scene& nearest, bool swapped) {
  constexpr studies::VisibilityGrid kGrid{2, -0.25};
  auto image = image::make_image(nearest.camera.width_px, nearest.camera.height_px, {"R", "G", "B"});
  const auto surfaces = studies::primary_visibility(nearest, kGrid, 1);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    float* const pixel = &image.pixels[i / 4 * 3];
    pixel[0] += (swapped ? surfaces[i].v : surfaces[i].u) / 4;
    pixel[1] += (swapped ? surfaces[i].u : surfaces[i].v) / 4;
  }
  return image;
}

}  // namespace

TEST(Probe, ExchangedTextureCoordinatesAreSeen) {
  const auto probe = studies::make_id_pass(two_boxes(), 128);
  const auto surfaces = studies::primary_visibility(probe.scene, {}, 1);
  const auto right = studies::compare_uv_pass(probe, surfaces, painted_coordinates(probe.scene, false));
  EXPECT_TRUE(right.mismatches.empty());
  EXPECT_GT(right.compared, 1000);
  const auto wrong = studies::compare_uv_pass(probe, surfaces, painted_coordinates(probe.scene, true));
  ASSERT_EQ(wrong.mismatches.size(), 2U);
  EXPECT_NE(wrong.mismatches[0].instead.find("where it has"), std::string::npos);
}

// Who writes a renderer reads it in a few lines, without a library.
TEST(Probe, TheRampIsAnExrWithoutCompression) {
  const ScratchFolder scratch("probe-ramp");
  const auto file = scratch.path() / "ramp.exr";
  studies::write_ramps(file, file.parent_path() / "ramp-of-eight-bits.png");
  const auto text = read_file(file);
  constexpr std::size_t kLine = 8 + 3 * sizeof(float) * studies::kRampSize;  // its place and size, B, G and R
  ASSERT_GT(text.size(), kLine * studies::kRampSize);
  const auto line_of = [&](int y) {
    std::array<float, 3 * studies::kRampSize> line{};
    std::memcpy(line.data(),
                &text[text.size() - kLine * static_cast<std::size_t>(studies::kRampSize - y) + 8],
                sizeof line);
    return line;
  };
  EXPECT_EQ(line_of(0)[0], 1);
  EXPECT_EQ(line_of(0)[studies::kRampSize], 255.5F / 256);
  EXPECT_EQ(line_of(200)[3 * studies::kRampSize - 1], 255.5F / 256);
}

namespace {

// The depths that a renderer with a box filter would write, as `mistake` makes them of the depth and of the
// length of the ray for a depth of 1.
image::Image depths(const studies::ProbeScene& probe, double (*mistake)(double depth, double length)) {
  constexpr studies::VisibilityGrid kGrid{8, -1.0 / 16};
  const auto& camera = probe.scene.camera;
  const auto frame = scene::camera_frame(camera);
  auto image = image::make_image(camera.width_px, camera.height_px, {"R", "G", "B", "depth.Z"});
  const auto surfaces = studies::primary_visibility(probe.scene, kGrid, 1);
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) {
      const double ray = length(scene::camera_ray(camera, frame, x + 0.5, y + 0.5).direction);
      const auto pixel = static_cast<std::size_t>(y * camera.width_px + x);
      double sum = 0;
      for (std::size_t k = 0; k < 64; ++k) sum += surfaces[64 * pixel + k].depth_m;
      image.at(x, y, 3) = static_cast<float>(mistake(sum / 64, ray));
    }
  return image;
}

studies::LayerFindings layer_findings(double (*mistake)(double depth, double length)) {
  const auto probe = studies::make_id_pass(two_boxes(), 128);
  return studies::compare_layers(probe, studies::primary_visibility(probe.scene, {}, 1),
                                 depths(probe, mistake), {"depth"});
}

}  // namespace

TEST(Probe, ComparesLayersWithWhatIsVisible) {
  const auto right = layer_findings([](double depth, double) { return depth; });
  EXPECT_EQ(right.fault, "");
  EXPECT_GT(right.compared, 500);
  const auto along_rays = layer_findings([](double depth, double length) { return depth * length; });
  EXPECT_NE(along_rays.fault.find("the layer 'depth' is along the ray"), std::string::npos)
      << along_rays.fault;
}

TEST(Probe, NamesTheLayersThatAreMissing) {
  const auto probe = studies::make_id_pass(two_boxes(), 128);
  const auto found =
      studies::compare_layers(probe, studies::primary_visibility(probe.scene, {}, 1),
                              depths(probe, [](double depth, double) { return depth; }), {"depth", "normal"});
  EXPECT_EQ(found.fault, "it lacks the layers normal");
}
