#pragma once

#include "base/nth.h"
#include "base/parallel.h"
#include "metrics/metric.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace orbs::metrics {

// Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli, "Image Quality Assessment: From Error Visibility to
// Structural Similarity", IEEE Transactions on Image Processing 13(4), 2004, eq. 13 with the window of its
// section III-C.
namespace ssim {

constexpr int kRadius = 5;  // 11 x 11 pixels
constexpr double kSigmaPx = 1.5;
constexpr double kC1 = 0.01 * 0.01;  // (K1 L)^2 with L = 1
constexpr double kC2 = 0.03 * 0.03;  // (K2 L)^2

using Weights = std::array<double, kRadius + 1>;  // by distance from the centre; the window is symmetric

inline Weights window_weights() {
  Weights weights{};
  double sum = 0.0;
  for (int i = 0; i <= kRadius; ++i) {
    const double weight = std::exp(-0.5 * i * i / (kSigmaPx * kSigmaPx));
    nth(weights, i) = weight;
    sum += i == 0 ? weight : 2.0 * weight;
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// What SSIM needs of each pixel: both lumas, their product and the sum of their squares. The variances enter
/// the formula only as a sum, so four filtered quantities are enough.
struct Moments {
  explicit Moments(std::size_t count) : x(count), y(count), xy(count), xx_yy(count) {}
  std::vector<double> x, y, xy, xx_yy;
};

/// Filters the pixels around `row` along the columns.
inline void filter_columns(const ImagePair& pair, const Weights& weights, int row, Moments& out) {
  const auto width = static_cast<std::size_t>(pair.width);
  for (auto* values : {&out.x, &out.y, &out.xy, &out.xx_yy}) std::fill(values->begin(), values->end(), 0.0);
  for (int k = -kRadius; k <= kRadius; ++k) {
    const double weight = nth(weights, std::abs(k));
    const double* const a = &pair.result_luma[static_cast<std::size_t>(row + k) * width];
    const double* const b = &pair.reference_luma[static_cast<std::size_t>(row + k) * width];
    for (std::size_t i = 0; i < width; ++i) {
      out.x[i] += weight * a[i];
      out.y[i] += weight * b[i];
      out.xy[i] += weight * (a[i] * b[i]);
      out.xx_yy[i] += weight * (a[i] * a[i] + b[i] * b[i]);
    }
  }
}

inline double filtered(const double* centre, const Weights& weights) {
  double sum = weights[0] * centre[0];
  for (int k = 1; k <= kRadius; ++k) sum += nth(weights, k) * (centre[-k] + centre[k]);
  return sum;
}

inline double index_at(const Moments& moments, const Weights& weights, std::size_t i) {
  const double mean_x = filtered(&moments.x[i], weights);
  const double mean_y = filtered(&moments.y[i], weights);
  const double means = mean_x * mean_y;
  const double squares = mean_x * mean_x + mean_y * mean_y;
  const double covariance = filtered(&moments.xy[i], weights) - means;
  const double variances = filtered(&moments.xx_yy[i], weights) - squares;
  return (2.0 * means + kC1) * (2.0 * covariance + kC2) / ((squares + kC1) * (variances + kC2));
}

}  // namespace ssim

inline MetricResult compute_ssim(const ImagePair& pair) {
  constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();
  image::Image map = image::make_image(pair.width, pair.height, {"Y"});
  std::fill(map.pixels.begin(), map.pixels.end(), kNoValue);
  const int rows = pair.height - 2 * ssim::kRadius;
  if (rows < 1 || pair.width <= 2 * ssim::kRadius) return {std::nullopt, std::move(map)};

  const auto weights = ssim::window_weights();
  const auto width = static_cast<std::size_t>(pair.width);
  std::vector<double> sums(static_cast<std::size_t>(rows), 0.0);
  std::vector<std::size_t> counts(sums.size(), 0);
  constexpr int kRowsPerTask = 32;
  for_each_index((rows + kRowsPerTask - 1) / kRowsPerTask, pair.threads, [&](int task) {
    ssim::Moments moments(width);
    for (int row = task * kRowsPerTask; row < std::min(rows, (task + 1) * kRowsPerTask); ++row) {
      const auto r = static_cast<std::size_t>(row);
      const std::size_t start = (r + ssim::kRadius) * width;
      ssim::filter_columns(pair, weights, row + ssim::kRadius, moments);
      for (std::size_t i = ssim::kRadius; i + ssim::kRadius < width; ++i) {
        const double index = ssim::index_at(moments, weights, i);
        map.pixels[start + i] = static_cast<float>(1.0 - index);
        if (pair.included[start + i] == 0) continue;
        sums[r] += index;
        ++counts[r];
      }
    }
  });
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t r = 0; r < sums.size(); ++r) {
    sum += sums[r];
    count += counts[r];
  }
  if (count == 0) return {std::nullopt, std::move(map)};
  return {sum / static_cast<double>(count), std::move(map)};
}

inline constexpr MetricInfo kSsim{
    "ssim",
    "1",
    Better::Higher,
    "structural similarity of Wang et al. 2004: window 11 x 11 Gaussian, sigma 1.5 px, weights of sum 1; "
    "K1 0.01, K2 0.03, L 1; population variance and covariance; on the luma .2126 R + .7152 G + .0722 B "
    "of the linear Rec.709 values clamped to [0, 1] and sRGB-encoded; mean over the windows that lie "
    "inside the image (the outer 5 px are no centres) and whose centre is unmasked (masked pixels beside "
    "it still enter the window); no value below 11 x 11 px",
    {"ssim", "1 - SSIM of the window around each pixel; NaN in the outer 5 px", false, 1.0F},
    compute_ssim};

}  // namespace orbs::metrics
