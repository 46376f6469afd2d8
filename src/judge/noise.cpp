#include "judge/noise.h"

#include "base/statistics.h"
#include "image/colour.h"
#include "metrics/psnr.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace orbs::judge {

namespace {

// Derivative of the sRGB curve as ORB.S states it, after the clamp.
double srgb_slope(double linear) {
  if (linear <= 0 || linear >= 1) return 0;
  return linear <= 0.0031308 ? 12.92 : 1.055 / 2.4 * std::pow(linear, 1 / 2.4 - 1);
}

// In steps of 1/255, squared. The delta method is for small errors: where a firefly has met a dark pixel it
// can exceed the square of the largest error that the clamp leaves room for. Ten pixels of a caustic made 27
// dB of its 38 that way.
double expected_square(double linear, double variance) {
  const double slope = 255 * srgb_slope(linear);
  const double value =
      255 * static_cast<double>(image::srgb_encode(std::clamp(static_cast<float>(linear), 0.0F, 1.0F)));
  const double largest = std::max(value, 255 - value);
  return std::min(slope * slope * variance, largest * largest);
}

// The variance of each of two pixels that differ by these steps (absolute values), without the largest 5 %,
// and the three channels of one pixel at least, so that single pixels that are wrong do not pass for noise.
// What is missing of normally distributed steps then is that beyond the z with P(|x| < z) = q: their second
// moment within is q - 2 z phi(z).
double variance_of_half_steps(std::vector<double>& steps) {
  constexpr std::size_t kOnePixel = 3;
  constexpr double kNormal = 1e9;  // degrees of freedom
  if (steps.size() <= 2 * kOnePixel) return 0;
  const auto kept = steps.size() - std::max(kOnePixel, steps.size() / 20);
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(kept), steps.end());
  double sum = 0;
  for (std::size_t i = 0; i < kept; ++i) sum += steps[i] * steps[i];
  const auto count = static_cast<double>(steps.size());
  const double q = static_cast<double>(kept) / count;
  const double z = student_quantile(1 - q, kNormal);
  const double density = std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
  return sum / (count * (q - 2 * z * density)) / 2;
}

}  // namespace

std::optional<double> noise_mse_srgb8(const std::vector<float>& variances,
                                      const std::vector<float>& values,
                                      const std::vector<std::uint8_t>& included) {
  if (variances.empty()) return std::nullopt;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t pixel = 0; pixel < included.size(); ++pixel) {
    if (included[pixel] == 0) continue;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
      sum += expected_square(static_cast<double>(values[i]), static_cast<double>(variances[i]));
    count += 3;
  }
  return sum / static_cast<double>(count);
}

std::optional<double> noise_mse_srgb8(const image::Image& image, const image::Image& values) {
  const auto samples = metrics::pair_samples(image, values);
  return noise_mse_srgb8(samples.result_variance, samples.reference, samples.included);
}

std::optional<double> scatter_mse_srgb8(const metrics::ImagePair& pair,
                                        const std::vector<std::uint8_t>& chosen) {
  constexpr int kApart_px = 4;
  constexpr double kFewest = 0.1;
  const auto difference = [&](std::size_t i) {
    return static_cast<double>(pair.result_display[i]) - static_cast<double>(pair.reference_display[i]);
  };
  double sum = 0;
  std::size_t count = 0;
  for (const Rectangle& block : metrics::blocks_of(pair)) {
    std::vector<double> steps;
    for (int y = block.y0; y < block.y1; ++y)
      for (int x = block.x0; x < std::min(block.x0 + kApart_px, block.x1 - kApart_px); ++x) {
        const auto a = pair.pixel_at(x, y);
        const auto b = pair.pixel_at(x + kApart_px, y);
        if (chosen[a] == 0 || chosen[b] == 0) continue;
        for (std::size_t c = 0; c < 3; ++c)
          steps.push_back(255 * std::fabs(difference(3 * a + c) - difference(3 * b + c)));
      }
    if (steps.empty()) continue;
    sum += static_cast<double>(steps.size()) * variance_of_half_steps(steps);
    count += steps.size();
  }
  // Each step is of two samples.
  if (2 * static_cast<double>(count) < kFewest * 3 * static_cast<double>(pair.included_count))
    return std::nullopt;
  return sum / static_cast<double>(count);
}

namespace {

// The brightest colour where all variances are too small for normal floats, and those of a noise that matters
// would be, too: the square of a ten-thousandth of the colour. An image of one colour has no noise to state.
std::optional<float> brightest_without_room(const image::Image& image) {
  constexpr float kLeast = std::numeric_limits<float>::min();
  constexpr double kShareThatMatters = 1e-4;
  const auto colours = image::select_rgb(image, "");
  const auto variances = image::select_rgb(image, "variance.");
  if (std::any_of(variances.pixels.begin(), variances.pixels.end(), [](float v) { return v >= kLeast; }))
    return std::nullopt;
  float brightest = 0;  // by its magnitude: a difference of images has negative colours
  for (const float value : colours.pixels) brightest = std::max(brightest, std::abs(value));
  const double noise = kShareThatMatters * static_cast<double>(brightest);
  if (noise * noise >= static_cast<double>(kLeast)) return std::nullopt;
  for (std::size_t i = 3; i < colours.pixels.size(); ++i)
    if (colours.pixels[i] != colours.pixels[i - 3]) return brightest;
  return std::nullopt;
}

}  // namespace

std::string variance_problem(const image::Image& image) {
  const auto is_there = [&](const char* name) { return image::channel_index(image, name) >= 0; };
  const std::array<const char*, 3> names{"variance.R", "variance.G", "variance.B"};
  if (std::none_of(names.begin(), names.end(), is_there)) return "";
  for (const char* name : names) {
    const int channel = image::channel_index(image, name);
    if (channel < 0) return fmt::format("there is no channel {} beside the others", name);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        if (const float value = image.at(x, y, static_cast<std::size_t>(channel));
            !(value >= 0) || std::isinf(value))
          return fmt::format("{} is {} at pixel ({}, {})", name, value, x, y);
  }
  if (const auto brightest = brightest_without_room(image))
    return fmt::format("no colour exceeds {}, and floats hold no variances of so dim an image", *brightest);
  return "";
}

image::Image without_variances(const image::Image& image) {
  auto names = image.channels;
  std::erase_if(names, [](const auto& name) { return image::is_variance(name); });
  auto rest = image::make_image(image.width, image.height, names);
  rest.attributes = image.attributes;
  for (std::size_t c = 0; c < names.size(); ++c) {
    const auto from = static_cast<std::size_t>(image::channel_index(image, names[c]));
    for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel)
      rest.pixels[pixel * names.size() + c] = image.pixels[pixel * image.channel_count() + from];
  }
  return rest;
}

double psnr_srgb8_of(double mse) { return metrics::psnr_db(255, mse); }

double mse_srgb8_of(double psnr_db) { return 255 * 255 * std::pow(10, -psnr_db / 10); }

}  // namespace orbs::judge
