#include "metrics/mean_ratio.h"

#include "metrics/describe.h"

#include <cctype>

#include <fmt/format.h>

namespace orbs::metrics::mean_ratio {

std::string describe(const Measurement& measurement, const Limits& limits) {
  const char channel = static_cast<char>(std::toupper(measurement.metric->name.back()));
  if (!measurement.value) return fmt::format("the mean of {} has nothing to be compared with", channel);
  constexpr double kPercent = 100;
  return fmt::format("the mean of {} is off by {:+.3g} % ({:+.3g} to {:+.3g}), {}", channel,
                     kPercent * *measurement.value, kPercent * measurement.low.value_or(0),
                     kPercent * measurement.high.value_or(0), limits_text(limits, kPercent, " %"));
}

}  // namespace orbs::metrics::mean_ratio
