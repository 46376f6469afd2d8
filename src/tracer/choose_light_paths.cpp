#include "tracer/choose_light_paths.h"

#include "image/colour.h"
#include "tracer/render.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace orbs::tracer {

namespace {

constexpr int kSide = 64;     // pixels of the trial image's longer side
constexpr int kSamples = 16;  // per pixel
// Light paths take a fifth to a half of the rendering time (measured on the mirror and glass scenes of
// ORB.S), so they must reduce noise by more.
constexpr double kWorthwhile = 0.78;
// A caustic that camera paths find once in a thousand samples is practically absent from the pixels of a
// trial. Means over blocks of them represent pixels with 1024 samples, where it dominates the noise. Scenes
// without caustics have about the same block noise with and without light paths.
constexpr int kBlockSide = 8;
constexpr double kBlocksWorthwhile = 0.5;

// If the camera sees only a corner of what the emitters illuminate, hardly any light path contributes, and
// the trial shows no noise because it shows no light. It is believed from this many contributions per pixel
// on.
constexpr double kFewestContributions = 0.25;
// An exception is made if the camera paths miss more than this part of the light.
constexpr double kMostOfLightMissed = 0.5;

float on_display(float radiance) { return image::srgb_encode(std::clamp(radiance, 0.0F, 1.0F)); }

struct Trial {
  std::array<image::Image, 2> images;  // with different seeds
  bool is_believable = false;
};

double sum_over(const image::Image& image, int x0, int y0, int side, std::size_t channel) {
  double sum = 0;
  for (int y = y0; y < y0 + side; ++y)
    for (int x = x0; x < x0 + side; ++x) sum += static_cast<double>(image.at(x, y, channel));
  return sum;
}

// Means over squares of side x side pixels, display-encoded.
std::vector<double> shown(const image::Image& image, int side) {
  std::vector<double> values;
  const double area = side * side;
  for (int y = 0; y + side <= image.height; y += side)
    for (int x = 0; x + side <= image.width; x += side)
      for (std::size_t c = 0; c < 3; ++c)
        values.push_back(on_display(static_cast<float>(sum_over(image, x, y, side, c) / area)));
  return values;
}

// Sum of (a - b) (c - d).
double product_of_differences(const std::vector<double>& a,
                              const std::vector<double>& b,
                              const std::vector<double>& c,
                              const std::vector<double>& d) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (c[i] - d[i]);
  return sum;
}

// Variance of one image, summed over its values.
double noise_of(const Trial& trial, int side) {
  const auto first = shown(trial.images[0], side);
  const auto second = shown(trial.images[1], side);
  return product_of_differences(first, second, first, second) / 2;
}

// Squared difference of the means of both, summed likewise. Its factors have independent noise, which
// averages out of the product.
double squared_bias(const Trial& a, const Trial& b, int side) {
  return product_of_differences(shown(a.images[0], side), shown(b.images[0], side), shown(a.images[1], side),
                                shown(b.images[1], side));
}

double light_of(const Trial& trial) {
  const image::Image& image = trial.images[0];
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) sum += static_cast<double>(image.at(x, y, c));
  return sum;
}

Trial trial_of(const World& world, int threads) {
  const std::atomic<bool> stop{false};
  const auto rendered = [&](std::uint64_t seed) {
    return render(world, {.samples_per_pixel = kSamples, .seed = seed, .threads = threads}, stop,
                  [](const Progress&) {});
  };
  auto a = rendered(1);
  auto b = rendered(2);
  const bool is_believable = static_cast<double>(a.light_path_contributions) >=
                             kFewestContributions * static_cast<double>(a.image.pixel_count());
  return {{std::move(a.image), std::move(b.image)}, is_believable};
}

// If camera paths hardly ever find a caustic, most pixels show neither light nor noise. The missing light is
// then an error like noise.
bool is_better(const Trial& with, const Trial& without) {
  if (light_of(without) < (1 - kMostOfLightMissed) * light_of(with)) return true;
  if (!with.is_believable) return false;
  return noise_of(with, 1) < kWorthwhile * noise_of(without, 1) ||
         noise_of(with, kBlockSide) <
             kBlocksWorthwhile * (noise_of(without, kBlockSide) + squared_bias(without, with, kBlockSide));
}

}  // namespace

bool choose_light_paths(World& world, int threads) {
  if (world.caustic_casters.empty()) return false;
  const PinholeCamera camera = world.camera;
  const double scale = static_cast<double>(kSide) / std::max(camera.width, camera.height);
  world.camera.width = std::max(1, static_cast<int>(camera.width * scale));
  world.camera.height = std::max(1, static_cast<int>(camera.height * scale));
  const Trial with = trial_of(world, threads);
  auto targets = std::exchange(world.caustic_casters, {});
  const Trial without = trial_of(world, threads);
  world.camera = camera;
  const bool worthwhile = is_better(with, without);
  if (worthwhile) world.caustic_casters = std::move(targets);
  return worthwhile;
}

}  // namespace orbs::tracer
