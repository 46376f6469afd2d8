#include "tracer/trial_image.h"

#include "image/colour.h"
#include "tracer/render.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace orbs::tracer {

namespace {

constexpr int kSamples = 16;  // per pixel

float on_display(float radiance) { return image::srgb_encode(std::clamp(radiance, 0.0F, 1.0F)); }

double sum_over(const image::Image& image, int x0, int y0, int side, std::size_t channel) {
  double sum = 0;
  for (int y = y0; y < y0 + side; ++y)
    for (int x = x0; x < x0 + side; ++x) sum += static_cast<double>(image.at(x, y, channel));
  return sum;
}

// Means over squares of side x side pixels, display-encoded.
std::vector<double> shown(const image::Image& image, float exposure, int side) {
  std::vector<double> values;
  const double scale = static_cast<double>(exposure) / (side * side);
  for (int y = 0; y + side <= image.height; y += side)
    for (int x = 0; x + side <= image.width; x += side)
      for (std::size_t c = 0; c < 3; ++c)
        values.push_back(on_display(static_cast<float>(sum_over(image, x, y, side, c) * scale)));
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

}  // namespace

Trial trial_of(World& world, int side, int threads) {
  const PinholeCamera camera = world.camera;
  // Records would take longer than the trial saves, and hide the noise that it is to see.
  const auto integrator = world.integrator;
  if (std::holds_alternative<scene::IrradianceCache>(integrator)) world.integrator = scene::PathTracing{};
  const double scale = static_cast<double>(side) / std::max(camera.width, camera.height);
  world.camera.width = std::max(1, static_cast<int>(camera.width * scale));
  world.camera.height = std::max(1, static_cast<int>(camera.height * scale));
  const std::atomic<bool> stop{false};
  const auto rendered = [&](std::uint64_t seed) {
    return render(world, {.samples_per_pixel = kSamples, .seed = seed, .threads = threads}, stop,
                  [](const Progress&) {});
  };
  auto a = rendered(1);
  auto b = rendered(2);
  world.camera = camera;
  world.integrator = integrator;
  const double contributions =
      static_cast<double>(a.light_path_contributions) / static_cast<double>(a.image.pixel_count());
  return {{std::move(a.image), std::move(b.image)}, contributions};
}

double light_of(const Trial& trial) {
  const image::Image& image = trial.images[0];
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) sum += static_cast<double>(image.at(x, y, c));
  return sum;
}

float exposure_of(const Trial& a, const Trial& b) {
  constexpr double kMean = 0.25;  // that of most scenes of ORB.S, which are seen as they are
  const double values = 3 * static_cast<double>(a.images[0].pixel_count() + b.images[0].pixel_count());
  const double mean = (light_of(a) + light_of(b)) / values;
  return mean > 0 ? static_cast<float>(kMean / mean) : 1;
}

double noise_of(const Trial& trial, float exposure, int block) {
  const auto first = shown(trial.images[0], exposure, block);
  const auto second = shown(trial.images[1], exposure, block);
  return product_of_differences(first, second, first, second) / 2;
}

double squared_bias(const Trial& a, const Trial& b, float exposure, int block) {
  return product_of_differences(shown(a.images[0], exposure, block), shown(b.images[0], exposure, block),
                                shown(a.images[1], exposure, block), shown(b.images[1], exposure, block));
}

}  // namespace orbs::tracer
