#pragma once

#include "metrics/describe.h"
#include "metrics/metric.h"

#include <cctype>
#include <cstddef>
#include <string>

#include <fmt/format.h>

namespace orbs::metrics {

namespace mean_ratio {

/// "R is 1.2 % brighter (0.9 to 1.5 %), at most 0.7 % is allowed".
inline std::string describe(const Measurement& measurement, const Limits& limits) {
  const char channel = static_cast<char>(std::toupper(measurement.metric->name.back()));
  if (!measurement.value) return fmt::format("the mean of {} has nothing to be compared with", channel);
  const double value = *measurement.value;
  Interval interval{value, measurement.low.value_or(value), measurement.high.value_or(value)};
  // What the first looks leave open says nothing of the image.
  if (measurement.to_pass && measurement.to_pass->reach_to_fail > 0)
    interval = {value, value - measurement.to_pass->reach_to_fail,
                value + measurement.to_pass->reach_to_fail};
  return fmt::format("{} is {}, {}", channel, lightness_text(interval), limits_text(limits, 100, " %"));
}

/// No value where the noise test gives no ratio: the reference's channel is black, or not above its noise.
template <std::size_t Channel>
MetricResult compute(const ImagePair& pair) {
  MetricResult result{std::nullopt};
  if (const auto& ratio = std::get<Channel>(pair.noise.mean_ratio)) {
    result.value = ratio->value;
    result.low = ratio->low;
    result.high = ratio->high;
    if (pair.looks > 1)
      result.to_pass = {ratio->to_pass.low, ratio->to_pass.high, ratio->reference_share,
                        ratio->reach_of_pixels};
  } else {
    result.absence = Absence::NothingInReference;
  }
  return result;
}

template <std::size_t Channel>
constexpr MetricInfo row(std::string_view name) {
  return {
      name,
      "1",
      Better::NearZero,
      "mean(result) / mean(reference) - 1 of one channel over all unmasked pixels; linear Rec.709, no "
      "clamp. The interval leaves out a right image in 1 of 21000 (delta method, Student's distribution), "
      "by the variances of both images, by the scatter of neighbouring 8 x 8 px blocks where the result "
      "has none, or by the reference's alone where its renderer has no noise",
      kNoMap,
      compute<Channel>,
      Computed::Always,
      GateRule::WholeInterval,
      describe};
}

}  // namespace mean_ratio

inline constexpr MetricInfo kMeanRatioR = mean_ratio::row<0>("mean_ratio_r");
inline constexpr MetricInfo kMeanRatioG = mean_ratio::row<1>("mean_ratio_g");
inline constexpr MetricInfo kMeanRatioB = mean_ratio::row<2>("mean_ratio_b");

}  // namespace orbs::metrics
