// The variances that the tracer states, beside the scatter of many renders with other seeds.
#include "scene/load/load_scene.h"
#include "tracer/render.h"
#include "tracer/world/build_world.h"

#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;
using tracer::RenderSettings;
using tracer::Sampler;

namespace {

constexpr int kSide_px = 32;
constexpr int kSeeds = 48;

struct Sums {
  double value = 0;
  double square = 0;
  double stated = 0;
};

// The sum of the stated variances over that of the true ones, of red over the image.
double stated_over_true(const std::string& file, RenderSettings settings) {
  auto scene = scene::load_scene(ORBS_SOURCE_DIR "/data/" + file);
  scene.camera.width_px = scene.camera.height_px = kSide_px;
  const auto world = tracer::make_world(scene);
  const std::atomic<bool> never{false};
  std::vector<Sums> pixels(std::size_t{kSide_px} * kSide_px);
  for (settings.seed = 1; settings.seed <= kSeeds; ++settings.seed) {
    const auto image = tracer::render(world, settings, never, [](const tracer::Progress&) {}).image;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const auto value = static_cast<double>(image.pixels[i * image.channel_count()]);
      pixels[i].value += value;
      pixels[i].square += value * value;
      pixels[i].stated += static_cast<double>(image.pixels[i * image.channel_count() + 3]);
    }
  }
  double found = 0;
  double stated = 0;
  for (const Sums& pixel : pixels) {
    found += (pixel.square - pixel.value * pixel.value / kSeeds) / (kSeeds - 1);
    stated += pixel.stated / kSeeds;
  }
  return stated / found;
}

struct Subject {
  const char* name;
  const char* file;
  int samples_per_pixel;
  Sampler sampler = Sampler::Sobol;
};

// Smooth light, edges of a lamp, glossy plates; a number of samples that is no power of two; and samplers
// whose points are less even.
const Subject kSubjects[] = {{"smooth_floor", "bench/smooth-floor.json", 32},
                             {"cornell_box", "bench/cornell-box.json", 32},
                             {"cornell_box_at_8", "bench/cornell-box.json", 8},
                             {"cornell_box_at_50", "bench/cornell-box.json", 50},
                             {"veach_plates", "bench/veach-plates.json", 32},
                             {"independent", "bench/cornell-box.json", 32, Sampler::Independent},
                             {"stratified", "bench/cornell-box.json", 32, Sampler::Stratified}};

class PixelVariance : public testing::TestWithParam<Subject> {};

}  // namespace

TEST_P(PixelVariance, IsThatOfOtherSeeds) {
  const auto& [name, file, spp, sampler] = GetParam();
  const double ratio = stated_over_true(file, {.samples_per_pixel = spp, .sampler = sampler});
  RecordProperty("stated_over_true", fmt::format("{:.3f}", ratio));
  EXPECT_GT(ratio, 0.8);
  EXPECT_LT(ratio, 1.25);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PixelVariance, testing::ValuesIn(kSubjects), [](const auto& subject) {
  return std::string(subject.param.name);
});
