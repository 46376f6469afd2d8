#include "metrics/window_numbers.h"

#include "metrics/describe.h"

#include <fmt/format.h>

namespace orbs::metrics {

std::string describe_window_error(const Measurement& measurement, const Limits& limits) {
  if (!measurement.value) return "the reference has no window with light to be compared with";
  constexpr double kPercent = 100;
  return fmt::format("the mean over {} is off by {:.3g} % or more for certain, {}",
                     rectangle_text(measurement.where.value_or(Rectangle{})), kPercent * *measurement.value,
                     limits_text(limits, kPercent, " %"));
}

std::string describe_line_error(const Measurement& measurement, const Limits& limits) {
  if (!measurement.value) return "the reference has no line with light to be compared with";
  constexpr double kPercent = 100;
  return fmt::format("a line of pixels in {} is off by {:.3g} % or more for certain, {}",
                     rectangle_text(measurement.where.value_or(Rectangle{})), kPercent * *measurement.value,
                     limits_text(limits, kPercent, " %"));
}

std::string describe_pattern_error(const Measurement& measurement, const Limits& limits) {
  if (measurement.what.empty()) return "no pattern of the difference stands out of its noise";
  return fmt::format("the image is {}: {:.3g} times as much as is allowed", measurement.what,
                     *measurement.value / limits.max.value_or(1));
}

}  // namespace orbs::metrics
