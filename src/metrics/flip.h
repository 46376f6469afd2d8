#pragma once

#include "base/in_double.h"
#include "metrics/flip_map.h"
#include "metrics/metric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace orbs::metrics {

namespace flip {

inline MetricResult mean_of_map(const ImagePair& pair, const std::vector<float>& error) {
  MetricResult result{std::nullopt, image::make_image(pair.width, pair.height, {"Y"})};
  double sum = 0.0;
  for (std::size_t pixel = 0; pixel < pair.pixel_count(); ++pixel)
    if (pair.included[pixel] != 0) sum += static_cast<double>(error[pixel]);
  result.value = sum / static_cast<double>(pair.included_count);
  result.map.pixels = error;
  return result;
}

/// The ACES curve of K. Narkowicz (2016) after the factor 0.6, as HDR-FLIP has it; clamped to [0, 1].
inline float aces(float value) {
  const float x = 0.6F * value;
  return std::clamp((2.51F * x * x + 0.03F * x) / (2.43F * x * x + 0.59F * x + 0.14F), 0.0F, 1.0F);
}

template <typename Curve>
std::vector<float> mapped(const std::vector<float>& linear, Curve curve) {
  std::vector<float> out(linear.size());
  std::transform(linear.begin(), linear.end(), out.begin(), curve);
  return out;
}

/// In stops. They take 2.0 and 0.18 to 0.85 on the screen with two steps between: fixed, so that numbers of
/// different references can be compared, which the choice by the reference's maximum and median does not
/// allow.
constexpr std::array kExposures_stops{0.08F, 1.24F, 2.40F, 3.56F};

}  // namespace flip

inline MetricResult compute_flip(const ImagePair& pair) {
  const auto shown = [](float value) { return std::clamp(value, 0.0F, 1.0F); };
  return flip::mean_of_map(
      pair, flip::error_map({pair.width, pair.height, pair.threads}, flip::mapped(pair.result, shown),
                            flip::mapped(pair.reference, shown)));
}

inline MetricResult compute_hdr_flip(const ImagePair& pair) {
  std::vector<float> largest(pair.pixel_count(), 0.0F);
  for (const float stops : flip::kExposures_stops) {
    const float factor = in_double::exp2(stops);
    const auto shown = [factor](float value) { return flip::aces(std::max(0.0F, factor * value)); };
    const auto error = flip::error_map({pair.width, pair.height, pair.threads},
                                       flip::mapped(pair.result, shown), flip::mapped(pair.reference, shown));
    std::transform(error.begin(), error.end(), largest.begin(), largest.begin(),
                   [](float a, float b) { return std::max(a, b); });
  }
  return flip::mean_of_map(pair, largest);
}

inline constexpr MetricInfo kFlip{
    "flip",
    "1",
    Better::Lower,
    "LDR-FLIP of Andersson et al. 2020 at 67.02 pixels per degree (a screen 0.7 m wide with 3840 px seen "
    "from 0.7 m), qc 0.7, pc 0.4, pt 0.95, w 0.082 degrees, qf 0.5, border pixels repeated; on linear "
    "Rec.709 values after the clamp to [0, 1], no exposure; mean over all unmasked pixels, from 0 to 1",
    {"flip", "LDR-FLIP error of each pixel, from 0 to 1", false, 1.0F},
    compute_flip,
    Computed::OnDemand};

inline constexpr MetricInfo kHdrFlip{
    "flip_hdr_fixed",
    "1",
    Better::Lower,
    "HDR-FLIP of Andersson et al. 2021 with fixed exposures: for each of 0.08, 1.24, 2.40 and 3.56 stops "
    "the linear Rec.709 values are multiplied by 2^stops, taken through the ACES curve (0.9036 x^2 + "
    "0.018 x) / (0.8748 x^2 + 0.354 x + 0.14) with the clamp to [0, 1], and compared by LDR-FLIP as in "
    "'flip'; the largest of the four errors of each pixel; mean over all unmasked pixels",
    {"flip_hdr_fixed", "HDR-FLIP error of each pixel at its worst of four fixed exposures, from 0 to 1",
     false, 1.0F},
    compute_hdr_flip,
    Computed::OnDemand};

}  // namespace orbs::metrics
