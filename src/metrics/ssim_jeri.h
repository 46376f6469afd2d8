#pragma once

#include "image/colour.h"
#include "metrics/metric.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace orbs::metrics {

/// SSIM as the image viewer JERI draws it, which is how the benchmark of M. Hruska's thesis (2020) showed
/// errors. It is not the SSIM of Wang et al.: see the definition. Only the mean is ours, JERI shows a map.
namespace ssim_jeri {

constexpr int kRadius = 2;
constexpr double kC1 = 0.01 * 0.01;
constexpr double kC2 = 0.03 * 0.03;

inline std::vector<double> displayed_luma(const std::vector<float>& linear) {
  const auto shown = [](float value) { return std::pow(std::max(static_cast<double>(value), 0.0), 1 / 2.2); };
  std::vector<double> luma(linear.size() / 3);
  for (std::size_t i = 0; i < luma.size(); ++i)
    luma[i] = image::luminance(shown(linear[3 * i]), shown(linear[3 * i + 1]), shown(linear[3 * i + 2]));
  return luma;
}

struct Sums {
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
};

// Pixels beyond the border are those of the border.
inline Sums sums_around(
    const ImagePair& pair, const std::vector<double>& a, const std::vector<double>& b, int x, int y) {
  Sums sums;
  for (int j = -kRadius; j <= kRadius; ++j)
    for (int i = -kRadius; i <= kRadius; ++i) {
      const auto at = static_cast<std::size_t>(std::clamp(y + j, 0, pair.height - 1)) *
                          static_cast<std::size_t>(pair.width) +
                      static_cast<std::size_t>(std::clamp(x + i, 0, pair.width - 1));
      sums.a += a[at];
      sums.b += b[at];
      sums.aa += a[at] * a[at];
      sums.bb += b[at] * b[at];
      sums.ab += a[at] * b[at];
    }
  return sums;
}

inline double index_of(const Sums& sums) {
  constexpr double kCount = (2 * kRadius + 1) * (2 * kRadius + 1);
  const double mean_a = sums.a / kCount;
  const double mean_b = sums.b / kCount;
  // JERI divides by n + 1, which is neither the population's n nor the sample's n - 1.
  const double variances = (sums.aa + sums.bb - kCount * (mean_a * mean_a + mean_b * mean_b)) / (kCount + 1);
  const double covariance = (sums.ab - kCount * mean_a * mean_b) / (kCount + 1);
  return (2 * mean_a * mean_b + kC1) * (2 * covariance + kC2) /
         ((mean_a * mean_a + mean_b * mean_b + kC1) * (variances + kC2));
}

}  // namespace ssim_jeri

inline MetricResult compute_ssim_jeri(const ImagePair& pair) {
  const auto a = ssim_jeri::displayed_luma(pair.result);
  const auto b = ssim_jeri::displayed_luma(pair.reference);
  image::Image map = image::make_image(pair.width, pair.height, {"Y"});
  double sum = 0.0;
  std::size_t pixel = 0;
  for (int y = 0; y < pair.height; ++y)
    for (int x = 0; x < pair.width; ++x, ++pixel) {
      const double index = ssim_jeri::index_of(ssim_jeri::sums_around(pair, a, b, x, y));
      map.pixels[pixel] = static_cast<float>(1.0 - index);
      if (pair.included[pixel] != 0) sum += index;
    }
  return {sum / static_cast<double>(pair.included_count), std::move(map)};
}

inline constexpr MetricInfo kSsimJeri{
    "ssim_jeri",
    "1",
    Better::Higher,
    "structural similarity as JERI's viewer computes it: window 5 x 5 without weights, border pixels "
    "repeated; K1 0.01, K2 0.03, L 1; variance and covariance divided by 26; on .2126 R + .7152 G + "
    ".0722 B of max(c, 0)^(1/2.2) of the linear Rec.709 values, no clamp at 1, no exposure; mean over "
    "all unmasked pixels as window centres (masked pixels beside them still enter). For comparison with "
    "images made with JERI; 'ssim' is the published definition",
    {"ssim_jeri", "1 - ssim_jeri of the window around each pixel", false, 1.0F},
    compute_ssim_jeri,
    Computed::OnDemand};

}  // namespace orbs::metrics
