#pragma once

#include "metrics/metric.h"
#include "metrics/mse.h"

#include <cmath>
#include <limits>
#include <utility>

namespace orbs::metrics {

/// 10 log10(peak^2 / mse) in dB; +infinity for mse 0, which only images without any difference have.
inline double psnr_db(double peak, double mse) {
  if (mse == 0.0) return std::numeric_limits<double>::infinity();
  return 10.0 * std::log10(peak * peak / mse);
}

inline MetricResult compute_psnr_srgb8(const ImagePair& pair) {
  MetricResult squared =
      mean_error(pair, pair.result_display, pair.reference_display, [](double t, double r) {
        const double steps = 255.0 * (t - r);
        return steps * steps;
      });
  return {psnr_db(255.0, *squared.value), std::move(squared.map)};
}

inline MetricResult compute_psnr_linear(const ImagePair& pair) {
  MetricResult squared = compute_mse(pair);
  return {psnr_db(1.0, *squared.value), std::move(squared.map)};
}

inline constexpr MetricInfo kPsnrSrgb8{
    "psnr_srgb8",
    "dB",
    Better::Higher,
    "10 log10(255^2 / MSE); MSE over the channels R, G, B of all unmasked pixels after the clamp of each "
    "linear Rec.709 value to [0, 1], the sRGB encoding (12.92 c up to 0.0031308, else 1.055 c^(1/2.4) - "
    "0.055) and the factor 255; not rounded to whole steps; infinite for equal images",
    {"squared_srgb8", "squared difference in each channel of the clamped, sRGB-encoded values times 255",
     false, 650.25F},
    compute_psnr_srgb8,
    Computed::Always,
    GateRule::NoiseAware};

inline constexpr MetricInfo kPsnrLinear{"psnr_linear",
                                        "dB",
                                        Better::Higher,
                                        "10 log10(1 / MSE) with the peak 1; MSE over the channels R, G, "
                                        "B of all unmasked pixels; linear Rec.709, no clamp, no "
                                        "exposure; infinite for equal images",
                                        kSquaredMap,
                                        compute_psnr_linear};

}  // namespace orbs::metrics
