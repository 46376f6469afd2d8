#pragma once

#include "metrics/metric.h"
#include "metrics/pixel_errors.h"

#include <algorithm>
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

// R. K. Mantiuk, M. Azimi, "PU21: A novel perceptually uniform encoding for adapting existing quality metrics
// for HDR", Image Coding Symposium 2021; the constants of the variant "banding_glare".
namespace pu21 {

constexpr double kWhite_cd_m2 = 100.0;  // the luminance of the value 1 on the screen that is assumed
constexpr double kDarkest_cd_m2 = 0.005;
constexpr double kBrightest_cd_m2 = 10000.0;
constexpr double kPeak = 256.0;  // the encoded value of 100 cd/m^2, to 0.1 %

inline double encode(double luminance_cd_m2) {
  const double y = std::clamp(luminance_cd_m2, kDarkest_cd_m2, kBrightest_cd_m2);
  const double power = std::pow(y, 0.9062562627);
  const double ratio = (0.353487901 + 0.3734658629 * power) / (1.0 + 8.277049286e-5 * power);
  return 596.3148142 * (std::pow(ratio, 0.09150303166) - 0.9099517204);
}

}  // namespace pu21

inline MetricResult compute_psnr_pu21(const ImagePair& pair) {
  MetricResult squared = mean_error(pair, pair.result, pair.reference, [](double t, double r) {
    if (t == r) return 0.0;
    const double difference = pu21::encode(pu21::kWhite_cd_m2 * t) - pu21::encode(pu21::kWhite_cd_m2 * r);
    return difference * difference;
  });
  return {psnr_db(pu21::kPeak, *squared.value), std::move(squared.map)};
}

inline constexpr MetricInfo kPsnrPu21{
    "psnr_pu21",
    "dB",
    Better::Higher,
    "10 log10(256^2 / MSE); MSE over the channels R, G, B of all unmasked pixels, each linear Rec.709 "
    "value times 100 cd/m^2, with the clamp to [0.005, 10000] cd/m^2 of PU21 (Mantiuk and Azimi 2021, "
    "banding_glare) and its encoding; no exposure; infinite where no encoded value differs",
    {"squared_pu21", "squared difference in each channel of the PU21-encoded values", false, 650.25F},
    compute_psnr_pu21,
    Computed::OnDemand};

}  // namespace orbs::metrics
