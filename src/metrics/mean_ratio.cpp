#include "metrics/mean_ratio.h"

#include "metrics/bias_message.h"
#include "metrics/describe.h"

#include <cctype>

#include <fmt/format.h>

namespace orbs::metrics::mean_ratio {

std::string describe(const Measurement& measurement, const Limits& limits) {
  const char channel = static_cast<char>(std::toupper(measurement.metric->name.back()));
  if (!measurement.value) return fmt::format("the mean of {} has nothing to be compared with", channel);
  const double value = *measurement.value;
  return fmt::format(
      "{} is {}, {}", channel,
      lightness_text({value, measurement.low.value_or(value), measurement.high.value_or(value)}),
      limits_text(limits, 100, " %"));
}

}  // namespace orbs::metrics::mean_ratio
