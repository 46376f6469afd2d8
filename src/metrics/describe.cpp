#include "metrics/describe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

namespace {

std::string percent(double value) { return fmt::format("{:+.3g} %", 100 * value); }

std::string one_side(double deviation) {
  const double side = std::max(deviation, -1.0);
  return fmt::format("{:.3g} % {}", 100 * std::fabs(side), side < 0 ? "darker" : "brighter");
}

std::string ratios_text(const NoiseTest& test) {
  constexpr std::array kChannels{"R", "G", "B"};
  std::vector<std::string> parts;
  for (std::size_t c = 0; c < 3; ++c)
    if (const auto& ratio = test.mean_ratio.at(c))
      parts.push_back(fmt::format("{} {}", kChannels.at(c), lightness_text(*ratio)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string blocks_text(const BlockScores& blocks) {
  const int side = kTestedBlocks_px.at(blocks.largest_at);
  const auto size = std::isinf(blocks.largest_error) ? std::string("from black")
                                                     : fmt::format("by {}", percent(blocks.largest_error));
  return fmt::format("bias: {} of {} block means differ by more than noise, most over {} x {} px in {}, {}",
                     blocks.off, blocks.tested, side, side, rectangle_text(blocks.where), size);
}

std::string residual_text(const SmoothResidual& residual) {
  return fmt::format("bias: away from edges an error of {:.2g} % is left that noise does not explain",
                     100 * std::sqrt(residual.bias_squared.value / residual.reference_squared));
}

std::string squares_text(const NoiseTest& test) {
  return fmt::format(
      "bias: noise explains {:.3g} of the mean squared error, {:.3g} is left ({:.3g} to {:.3g})",
      test.noise_squared, test.bias_squared.value, test.bias_squared.low, test.bias_squared.high);
}

std::string correlation_text(const Correlation& correlation) {
  return fmt::format(
      "the errors of pixels ({}, {}) apart are correlated by {:.2g}: a filter wider than a pixel, a denoiser, "
      "or an error with structure",
      correlation.dx, correlation.dy, correlation.value);
}

std::string near_areas_text(const NearAreas& areas) {
  return fmt::format(
      "its means over {0} x {0} px are nearer to the reference than the noise of their pixels allows: the square of "
      "their error is {1:.2g} of what independent pixels make, over {2} of them. Samples that depend on those of "
      "other pixels do that, and so does a correction by the reference",
      areas.side_px, areas.share, areas.count);
}

}  // namespace

std::string lightness_text(const Interval& deviation) {
  const auto& [value, low, high] = deviation;
  // Nothing is darker by more than 100 %: what lacks more than all of its light is negative.
  if (value < -1)
    return fmt::format("of negative light, {:.3g} % of what is right ({:.3g} to {:.3g} %)", 100 * (1 + value),
                       100 * (1 + low), 100 * (1 + high));
  if (low * high < 0) return fmt::format("{} ({} to {})", one_side(value), one_side(low), one_side(high));
  const double most = std::max(std::fabs(low), std::fabs(high));
  return fmt::format("{} ({:.3g} to {:.3g} %)", one_side(value),
                     100 * std::min(std::fabs(low), std::fabs(high)),
                     100 * (value < 0 ? std::min(most, 1.0) : most));
}

std::vector<std::string> bias_remarks(const NoiseTest& test) {
  std::vector<std::string> remarks;
  if (mean_error(test))
    remarks.push_back(fmt::format("bias: the means differ by more than noise: {}", ratios_text(test)));
  if (!test.patterns.empty() && is_within_range(test.patterns.front()))
    remarks.push_back(fmt::format("bias: the image is {}", describe(test.patterns.front())));
  if (test.blocks.off > 0) remarks.push_back(blocks_text(test.blocks));
  if (is_residual(test)) remarks.push_back(residual_text(*test.smooth));
  if (test.correlation) remarks.push_back(correlation_text(*test.correlation));
  if (test.near_areas) remarks.push_back(near_areas_text(*test.near_areas));
  if (remarks.empty() && is_square_biased_beyond_edges(test)) remarks.push_back(squares_text(test));
  return remarks;
}

std::string bias_message(const NoiseTest& test) {
  if (const auto remarks = bias_remarks(test); !remarks.empty()) return remarks.front();
  if (is_square_biased(test)) return squares_text(test);
  return "";
}

std::string hidden_by_noise(const NoiseTest& test) {
  struct Wanted {
    int side_px;
    double error;
  };
  constexpr std::array<Wanted, 2> kWanted{{{64, 0.02}, {16, 0.05}}};
  for (const auto& [side, error] : kWanted)
    for (const auto& scale : test.blocks.scales)
      if (scale.side_px == side && scale.smallest_error && *scale.smallest_error > error)
        return fmt::format("noise hides errors below {:.2g} % over {} x {} px", 100 * *scale.smallest_error,
                           side, side);
  return "";
}

}  // namespace orbs::metrics
