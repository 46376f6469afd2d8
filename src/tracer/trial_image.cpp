#include "tracer/trial_image.h"

#include "tracer/render.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace orbs::tracer {

std::optional<TrialSize> trial_size(const Camera& camera,
                                    const RenderSettings& settings,
                                    double share,
                                    int images) {
  // The ratio of two sums of squares over so many pixels is known to about a quarter.
  constexpr double kFewestPixels = 96;
  constexpr double kMostPixels = 1024;
  constexpr int kFewestSamples = 4;
  constexpr int kMostSamples = 256;
  const double pixels = static_cast<double>(camera.width) * camera.height;
  const double paths = share * pixels * settings.samples_per_pixel / images;
  const int samples = std::clamp(static_cast<int>(paths / std::min(kFewestPixels, pixels)), 0,
                                 std::min(settings.samples_per_pixel, kMostSamples));
  if (samples < std::min(kFewestSamples, settings.samples_per_pixel)) return std::nullopt;
  const double shrink = std::sqrt(std::min({paths / samples, kMostPixels, pixels}) / pixels);
  const auto side = [&](int length) { return std::max(1, static_cast<int>(std::lround(length * shrink))); };
  return TrialSize{side(camera.width), side(camera.height), samples};
}

Trial trial_of(World& world, const TrialSize& size, const RenderSettings& settings) {
  const Camera camera = world.camera;
  // Records would take longer than the trial saves, and hide the noise that it is to see.
  const auto integrator = world.integrator;
  if (std::holds_alternative<scene::IrradianceCache>(integrator)) world.integrator = scene::PathTracing{};
  world.camera.width = size.width;
  world.camera.height = size.height;
  const std::atomic<bool> stop{false};
  const auto rendered = [&](std::uint64_t seed) {
    return render(world,
                  {.samples_per_pixel = size.samples_per_pixel,
                   .seed = seed,
                   .threads = settings.threads,
                   .sampler = settings.sampler,
                   .variances = false},
                  stop, [](const Progress&) {});
  };
  auto a = rendered(1);
  auto b = rendered(2);
  world.camera = camera;
  world.integrator = integrator;
  const double contributions =
      static_cast<double>(a.light_path_contributions) / static_cast<double>(a.image.pixel_count());
  return {{std::move(a.image), std::move(b.image)},
          contributions,
          {a.seconds + b.seconds, a.cpu_seconds + b.cpu_seconds, a.traversal_seconds + b.traversal_seconds}};
}

namespace {

Vec3d colour_of(const image::Image& image, std::size_t pixel) {
  const float* value = &image.pixels[pixel * image.channel_count()];
  return {static_cast<double>(value[0]), static_cast<double>(value[1]), static_cast<double>(value[2])};
}

// Of both techniques together.
std::vector<double> light_of_pixels(const Trial& a, const Trial& b) {
  std::vector<double> light(a.images[0].pixel_count());
  for (std::size_t i = 0; i < light.size(); ++i) {
    const Vec3d sum = colour_of(a.images[0], i) + colour_of(a.images[1], i) + colour_of(b.images[0], i) +
                      colour_of(b.images[1], i);
    light[i] = std::abs(sum.x + sum.y + sum.z) / 12;
  }
  return light;
}

// What counts as black: a tenth of the median of the pixels that have any light.
double darkness(std::vector<double> light) {
  constexpr double kOfMedian = 0.1;
  std::erase(light, 0.0);
  if (light.empty()) return 0;
  const auto middle = light.begin() + static_cast<std::ptrdiff_t>(light.size() / 2);
  std::nth_element(light.begin(), middle, light.end());
  return kOfMedian * *middle;
}

double bounded(double error) { return error / (1 + error); }

}  // namespace

RelativeErrors relative_errors(const Trial& first, const Trial& second) {
  const auto light = light_of_pixels(first, second);
  const double dark = darkness(light);
  RelativeErrors noise;
  RelativeErrors missed;
  double pixels = 0;
  for (std::size_t i = 0; i < light.size(); ++i) {
    const double unit = 3 * (light[i] * light[i] + dark * dark);  // of squares summed over three channels
    if (!(unit > 0)) continue;
    ++pixels;
    const Vec3d apart_first = colour_of(first.images[0], i) - colour_of(first.images[1], i);
    const Vec3d apart_second = colour_of(second.images[0], i) - colour_of(second.images[1], i);
    noise.first += bounded(dot(apart_first, apart_first) / 2 / unit);
    noise.second += bounded(dot(apart_second, apart_second) / 2 / unit);
    // The two factors have independent noise, which averages out of their product.
    const Vec3d by_seed_1 = colour_of(first.images[0], i) - colour_of(second.images[0], i);
    const Vec3d by_seed_2 = colour_of(first.images[1], i) - colour_of(second.images[1], i);
    const Vec3d more = by_seed_1 + by_seed_2;
    const double product = std::clamp(dot(by_seed_1, by_seed_2) / unit, -1.0, 1.0);
    (more.x + more.y + more.z > 0 ? missed.second : missed.first) += product;
  }
  if (pixels == 0) return {};
  const auto whole = [&](double of_noise, double of_missed) {
    constexpr double kMost = 0.999;  // beyond which all is as good as missed
    const double mean = std::min(kMost, (of_noise + std::max(0.0, of_missed)) / pixels);
    return mean / (1 - mean);
  };
  return {whole(noise.first, missed.first), whole(noise.second, missed.second)};
}

double typical_variance_ratio(const Trial& first, const Trial& second) {
  double shares = 0;
  double pixels = 0;
  for (std::size_t i = 0; i < first.images[0].pixel_count(); ++i) {
    const Vec3d apart_first = colour_of(first.images[0], i) - colour_of(first.images[1], i);
    const Vec3d apart_second = colour_of(second.images[0], i) - colour_of(second.images[1], i);
    const double square_first = dot(apart_first, apart_first);
    const double squares = square_first + dot(apart_second, apart_second);
    if (!(squares > 0)) continue;
    shares += square_first / squares;
    ++pixels;
  }
  if (pixels == 0) return 1;
  // Of two squared normal numbers with the ratio q of their standard deviations the share has the mean
  // q / (1 + q): the ratio of the numbers is Cauchy distributed.
  constexpr double kMost = 0.999;
  const double share = std::min(kMost, shares / pixels);
  const double ratio = share / (1 - share);
  return ratio * ratio;
}

}  // namespace orbs::tracer
