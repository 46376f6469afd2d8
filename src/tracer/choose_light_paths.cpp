#include "tracer/choose_light_paths.h"

#include "image/colour.h"
#include "tracer/render.h"

#include <algorithm>
#include <array>
#include <utility>

namespace orbs::tracer {

namespace {

constexpr int kSide = 64;     // pixels of the trial picture's longer side
constexpr int kSamples = 16;  // per pixel
// Light paths take a fifth to a half of a render's time (measured on mirrors and glass of the ORB.S scenes),
// so the noise has to fall by more.
constexpr double kWorthwhile = 0.78;
// A caustic that camera paths find once in a thousand samples is as good as absent from the pixels of a
// trial; the means over blocks of them stand for pixels with 1024 samples, where it is the noise. Scenes
// without one have about the same noise with and without light paths there.
constexpr int kBlockSide = 8;
constexpr double kBlocksWorthwhile = 0.5;

// Where the camera sees a corner of what the lamps light, hardly any light path arrives: the trial then shows
// no noise because it shows no light. So many contributions per pixel of it, at least, make it believable.
constexpr double kFewestArrivals = 0.25;
// Unless the camera paths find even less.
constexpr double kMostOfLightMissed = 0.5;

float on_display(float radiance) { return image::srgb_encode(std::clamp(radiance, 0.0F, 1.0F)); }

struct Trial {
  std::array<image::Image, 2> pictures;  // with different random numbers
  double light = 0;                      // sum of all pixels
  bool is_believable = false;
};

double sum_over(const image::Image& picture, int x0, int y0, int side, std::size_t channel) {
  double sum = 0;
  for (int y = y0; y < y0 + side; ++y)
    for (int x = x0; x < x0 + side; ++x) sum += static_cast<double>(picture.at(x, y, channel));
  return sum;
}

// The sum over squares of pixels, of which each is one value as a display shows it, of
// (a[0] - b[0]) (a[1] - b[1]).
double product_of_differences(const std::array<const image::Image*, 2>& a,
                              const std::array<const image::Image*, 2>& b,
                              int side) {
  double sum = 0;
  const double area = side * side;
  for (int y = 0; y + side <= a[0]->height; y += side)
    for (int x = 0; x + side <= a[0]->width; x += side)
      for (std::size_t c = 0; c < 3; ++c) {
        const auto shown = [&](const image::Image& picture) -> double {
          return on_display(static_cast<float>(sum_over(picture, x, y, side, c) / area));
        };
        sum += (shown(*a[0]) - shown(*b[0])) * (shown(*a[1]) - shown(*b[1]));
      }
  return sum;
}

// Variance of one picture, as a display shows it: mean square times number of values.
double noise_of(const Trial& trial, int side) {
  const auto& [first, second] = trial.pictures;
  return product_of_differences({&first, &first}, {&second, &second}, side) / 2;
}

// The square of what blocks of one trial lack in the mean of both pictures: noise of different random numbers
// averages out of the product.
double squared_bias(const Trial& a, const Trial& b) {
  return product_of_differences({&a.pictures[0], &a.pictures[1]}, {&b.pictures[0], &b.pictures[1]},
                                kBlockSide);
}

Trial trial_of(const World& world) {
  const std::atomic<bool> stop{false};
  const auto rendered = [&](std::uint64_t seed) {
    return render(world, {.samples_per_pixel = kSamples, .seed = seed}, stop, [](const Progress&) {});
  };
  auto a = rendered(1);
  auto b = rendered(2);
  Trial trial;
  for (int y = 0; y < a.picture.height; ++y)
    for (int x = 0; x < a.picture.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) trial.light += sum_over(a.picture, x, y, 1, c);
  trial.is_believable = static_cast<double>(a.arrived_light_paths) >=
                        kFewestArrivals * static_cast<double>(a.picture.pixel_count());
  trial.pictures = {std::move(a.picture), std::move(b.picture)};
  return trial;
}

// Of a caustic that camera paths hardly ever find, nearly all pixels show nothing and so no noise; that it is
// missing is an error like noise.
bool is_better(const Trial& with, const Trial& without) {
  if (without.light < (1 - kMostOfLightMissed) * with.light) return true;
  if (!with.is_believable) return false;
  return noise_of(with, 1) < kWorthwhile * noise_of(without, 1) ||
         noise_of(with, kBlockSide) <
             kBlocksWorthwhile * (noise_of(without, kBlockSide) + squared_bias(without, with));
}

}  // namespace

bool choose_light_paths(World& world) {
  if (world.light_path_targets.empty()) return false;
  const PinholeCamera camera = world.camera;
  const double scale = static_cast<double>(kSide) / std::max(camera.width, camera.height);
  world.camera.width = std::max(1, static_cast<int>(camera.width * scale));
  world.camera.height = std::max(1, static_cast<int>(camera.height * scale));
  const Trial with = trial_of(world);
  auto targets = std::exchange(world.light_path_targets, {});
  const Trial without = trial_of(world);
  world.camera = camera;
  const bool worthwhile = is_better(with, without);
  if (worthwhile) world.light_path_targets = std::move(targets);
  return worthwhile;
}

}  // namespace orbs::tracer
