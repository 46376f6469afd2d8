#include "runner/noise.h"

#include "metrics/psnr.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace orbs::runner {

namespace {

// Derivative of the sRGB curve as ORB.S states it, after the clamp.
double srgb_slope(double linear) {
  if (linear <= 0 || linear >= 1) return 0;
  return linear <= 0.0031308 ? 12.92 : 1.055 / 2.4 * std::pow(linear, 1 / 2.4 - 1);
}

}  // namespace

std::optional<double> noise_mse_srgb8(const image::Image& picture, const metrics::Mask& mask) {
  constexpr std::array kChannels{"R", "G", "B"};
  constexpr std::array kVariances{"variance.R", "variance.G", "variance.B"};
  std::array<std::size_t, 3> values{};
  std::array<std::size_t, 3> variances{};
  for (std::size_t c = 0; c < 3; ++c) {
    const int value = image::channel_index(picture, kChannels.at(c));
    const int variance = image::channel_index(picture, kVariances.at(c));
    if (value < 0 || variance < 0) return std::nullopt;
    values.at(c) = static_cast<std::size_t>(value);
    variances.at(c) = static_cast<std::size_t>(variance);
  }
  const auto included = metrics::included_pixels(mask, picture.width, picture.height);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t pixel = 0; pixel < included.size(); ++pixel) {
    if (included[pixel] == 0) continue;
    const float* const samples = &picture.pixels[pixel * picture.channel_count()];
    for (std::size_t c = 0; c < 3; ++c) {
      const double slope = 255 * srgb_slope(static_cast<double>(samples[values.at(c)]));
      sum += slope * slope * static_cast<double>(samples[variances.at(c)]);
    }
    count += 3;
  }
  return sum / static_cast<double>(count);
}

double psnr_srgb8_of(double mse) { return metrics::psnr_db(255, mse); }

}  // namespace orbs::runner
