#pragma once

#include "metrics/metric.h"

namespace orbs::metrics {

// The errors over windows of window_error.h as metrics. The index is that of kWindows_px.
template <std::size_t Window>
MetricResult compute_window_error(const ImagePair& pair) {
  const auto& worst = std::get<Window>(pair.noise.windows);
  if (!worst) return {.value = std::nullopt, .absence = Absence::NothingInReference};
  MetricResult result{.value = worst->value, .where = worst->where};
  if (worst->largest > 0) result.to_pass = ToPass{0, worst->largest};
  return result;
}

/// "the mean over [16,0,32,16] is off by 12 % or more for certain, at most 3 % is allowed".
std::string describe_window_error(const Measurement& measurement, const Limits& limits);

inline constexpr MetricInfo kWindowError8{
    "window_error_8px",
    "1",
    Better::Lower,
    "the largest |mean(result) - mean(reference)| over the unmasked pixels of any window of 8 x 8 px, less the "
    "reach of its noise and what edges 0.05 px away make, over the larger of the reference's means of window "
    "and image; of R, G and B the worst; linear Rec.709, no clamp",
    kNoMap,
    compute_window_error<0>,
    Computed::Always,
    GateRule::Certain,
    describe_window_error};

inline constexpr MetricInfo kWindowError16{
    "window_error_16px",
    "1",
    Better::Lower,
    "the largest |mean(result) - mean(reference)| over the unmasked pixels of any window of 16 x 16 px, less the "
    "reach of its noise and what edges 0.05 px away make, over the reference's mean of the window, at least a "
    "tenth of the image's; of R, G and B the worst; linear Rec.709, no clamp",
    kNoMap,
    compute_window_error<1>,
    Computed::Always,
    GateRule::CertainShare,
    describe_window_error};

inline constexpr MetricInfo kWindowError64{
    "window_error_64px",
    "1",
    Better::Lower,
    "the same as window_error_16px over the unmasked pixels of windows of 64 x 64 px; linear Rec.709, no clamp",
    kNoMap,
    compute_window_error<2>,
    Computed::Always,
    GateRule::CertainShare,
    describe_window_error};

inline MetricResult compute_line_error(const ImagePair& pair) {
  const auto& worst = pair.noise.line;
  if (!worst) return {.value = std::nullopt, .absence = Absence::NothingInReference};
  return {.value = worst->value, .where = worst->where};
}

/// "a line of pixels in [0,0,128,128] is off by 12 % or more for certain, at most 10 % is allowed".
std::string describe_line_error(const Measurement& measurement, const Limits& limits);

inline constexpr MetricInfo kLineError{
    "line_error",
    "1",
    Better::Lower,
    "the largest |mean(result) - mean(reference)| over the unmasked pixels of any line of 16, 32, 64 ... px, of any "
    "slope and one pixel wide, less the reach of its noise and what edges 0.2 px away make, over the larger of the "
    "reference's means of line and image; of R, G and B the worst; linear Rec.709, no clamp",
    kNoMap,
    compute_line_error,
    Computed::Always,
    GateRule::Certain,
    describe_line_error};

/// A difference of images has no mean level, and black has no patterns. What lies beyond a pattern's range is
/// another error, which other gates see.
inline MetricResult compute_pattern_error(const ImagePair& pair) {
  MetricResult worst{.value = 0};
  for (const auto& finding : pair.noise.patterns)
    if (is_within_range(finding) && finding.excess > *worst.value)
      worst = {.value = finding.excess, .what = describe(finding)};
  return worst;
}

/// "the image is shifted to the right by 0.5 px (0.4 to 0.6): 1.3 times what is allowed for certain".
std::string describe_pattern_error(const Measurement& measurement, const Limits& limits);

inline constexpr MetricInfo kPatternError{
    "pattern_error",
    "1",
    Better::Lower,
    "the largest amplitude of any pattern of the difference (gradients, contrast, shadows, highlights, black level, "
    "saturation, hue, shifts, rotation, scale, sharpness, gamma, stripes, checkerboard) less the reach of its "
    "noise, over the largest that is allowed; unmasked pixels, linear Rec.709, no clamp",
    kNoMap,
    compute_pattern_error,
    Computed::Always,
    GateRule::Certain,
    describe_pattern_error};

}  // namespace orbs::metrics
