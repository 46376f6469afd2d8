// Paths that carry wavelengths are hardly noisier than paths that carry colours, where colours are all there
// is.
#include "image/image.h"
#include "scene/load/load_scene.h"
#include "tracer/render.h"
#include "tracer/world/build_world.h"

#include <atomic>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;
using scene::LightTransport;

constexpr int kSide_px = 24;
constexpr int kSeeds = 24;

// A room with a red, a green and white walls, and a lamp.
scene::Scene room() {
  auto scene = scene::load_scene(ORBS_SOURCE_DIR "/data/cases/orbs/m1_lambert/101.json");
  scene.camera.width_px = scene.camera.height_px = kSide_px;
  return scene;
}

// Sum over pixels and channels of the variance over seeds.
double variance_of(int samples_per_pixel, LightTransport transport) {
  const auto world = tracer::make_world(room(), {.transport = transport});
  const std::atomic<bool> never{false};
  std::vector<double> sums(std::size_t{3} * kSide_px * kSide_px);
  std::vector<double> squares(sums.size());
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const auto rendering = tracer::render(world, {.samples_per_pixel = samples_per_pixel, .seed = seed},
                                          never, [](const tracer::Progress&) {});
    const auto image = image::select_rgb(rendering.image, "");
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const auto value = static_cast<double>(image.pixels[i]);
      sums[i] += value;
      squares[i] += value * value;
    }
  }
  double out = 0;
  for (std::size_t i = 0; i < sums.size(); ++i)
    out += (squares[i] - sums[i] * sums[i] / kSeeds) / (kSeeds - 1);
  return out;
}

}  // namespace

// Four wavelengths stand for all others, which costs noise: at most a seventh more.
TEST(SpectralVariance, IsHardlyMoreThanThatOfColours) {
  constexpr int kSamplesPerPixel = 16;
  const double ratio = variance_of(kSamplesPerPixel, LightTransport::Spectral) /
                       variance_of(kSamplesPerPixel, LightTransport::Rgb);
  EXPECT_LT(ratio, 1.15);
  RecordProperty("ratio", fmt::format("{:.3f}", ratio));
}
