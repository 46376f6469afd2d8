#include "metrics/describe.h"

#include <cmath>

#include <fmt/format.h>

namespace orbs::metrics {

namespace {

std::string number_text(double value, std::string_view unit) {
  if (std::isinf(value)) return "infinite";
  return unit == "1" ? fmt::format("{:.4g}", value) : fmt::format("{:.4g} {}", value, unit);
}

}  // namespace

bool is_within(double value, const Limits& limits) {
  return !std::isnan(value) && (!limits.min || value >= *limits.min) && (!limits.max || value <= *limits.max);
}

std::string limits_text(const Limits& limits, double scale, const std::string& unit) {
  const auto text = [&](double limit) { return fmt::format("{:.3g}{}", scale * limit, unit); };
  if (limits.max && (!limits.min || *limits.min == -*limits.max))
    return fmt::format("at most {} is allowed", text(*limits.max));
  if (!limits.max) return fmt::format("at least {} is needed", text(limits.min.value_or(0)));
  return fmt::format("from {} to {} is allowed", text(*limits.min), text(*limits.max));
}

std::string describe(const Measurement& measurement, const Limits& limits) {
  const auto& metric = *measurement.metric;
  if (metric.describe != nullptr) return metric.describe(measurement, limits);
  if (!measurement.value) return fmt::format("{} has no value for this image", metric.name);
  auto text = fmt::format("{} is {}", metric.name, number_text(*measurement.value, metric.unit));
  if (limits.min && !(*measurement.value >= *limits.min))
    text += fmt::format(", at least {} is needed", *limits.min);
  else if (limits.max && !(*measurement.value <= *limits.max))
    text += fmt::format(", at most {} is allowed", *limits.max);
  return text;
}

}  // namespace orbs::metrics
