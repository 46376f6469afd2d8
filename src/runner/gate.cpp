#include "runner/gate.h"

#include "metrics/noise_numbers.h"
#include "metrics/table.h"
#include "runner/noise.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::runner {

namespace {

using results::Verdict;

std::string number_text(double value, const std::string& unit) {
  return std::isinf(value)
             ? "infinite"
             : fmt::format("{:.4g}{}{}", value, unit == "1" ? "" : " ", unit == "1" ? "" : unit);
}

// Twice the squared error. The tests of bias are what finds a wrong image; this is for what they cannot see
// because fireflies rule the linear values. It leaves room for what the delta method leaves out, the bend and
// the clamp of the curve: 0.7 dB in a control image of edges and sky with 4 samples.
constexpr double kNoiseSlack_db = 3;

double mse_srgb8_of(double psnr_db) { return 255 * 255 * std::pow(10, -psnr_db / 10); }

// The noise of the result falls with its samples, that of the reference stays. All of the error is noise
// here.
std::string samples_needed(double mse, double allowed_mse, double reference_mse) {
  if (allowed_mse <= reference_mse) return "the reference is too noisy for this gate";
  const double factor = (mse - reference_mse) / (allowed_mse - reference_mse);
  return fmt::format("needs about {:.2g} times the samples", factor);
}

// A psnr_srgb8 below what the gate asks for.
GateResult below_psnr(const std::string& is, double value, double least, const GateNoise& noise) {
  const Verdict fail = Verdict::Fail;
  const auto missed = fmt::format("{}, at least {} is needed", is, least);
  if (!noise.result_mse && !noise.reference_mse) return {fail, missed};
  const double expected_db = psnr_srgb8_of(noise.result_mse.value_or(0) + noise.reference_mse.value_or(0));
  if (value < expected_db - kNoiseSlack_db) return {fail, missed};
  // A right image with this noise would measure the same, but would show no bias.
  if (!noise.bias.empty()) return {fail, fmt::format("{}; {}", missed, noise.bias)};
  return {
      Verdict::Inconclusive,
      fmt::format("{}, but noise alone gives {}: {}", missed, number_text(expected_db, "dB"),
                  samples_needed(mse_srgb8_of(value), mse_srgb8_of(least), noise.reference_mse.value_or(0)))};
}

}  // namespace

GateNoise gate_noise(const image::Image& result,
                     const image::Image& reference,
                     const metrics::Mask& mask,
                     const metrics::NoiseTest& test) {
  return {noise_mse_srgb8(result, reference, mask), noise_mse_srgb8(reference, reference, mask),
          metrics::bias_message(test)};
}

GateResult check_gate(const registry::Gate& gate, std::optional<double> value, const GateNoise& noise) {
  if (!value) return {Verdict::Inconclusive, fmt::format("{} has no value for this image", gate.metric)};
  const std::string unit(metrics::find_metric(gate.metric).unit);
  const auto is = fmt::format("{} is {}", gate.metric, number_text(*value, unit));
  if (gate.min && !(*value >= *gate.min)) {
    if (gate.metric == "psnr_srgb8") return below_psnr(is, *value, *gate.min, noise);
    return {Verdict::Fail, fmt::format("{}, at least {} is needed", is, *gate.min)};
  }
  if (gate.max && !(*value <= *gate.max))
    return {Verdict::Fail, fmt::format("{}, at most {} is allowed", is, *gate.max)};
  return {Verdict::Pass, is};
}

GateResult check_mean_ratio(const std::string& channel,
                            double tolerance,
                            const std::optional<metrics::Estimate>& ratio) {
  if (!ratio) return {Verdict::Pass, fmt::format("the mean of {} has nothing to be compared with", channel)};
  const auto is =
      fmt::format("the mean of {} is off by {:+.3g} % ({:+.3g} to {:+.3g}), at most {:.3g} % is allowed",
                  channel, 100 * ratio->value, 100 * ratio->low, 100 * ratio->high, 100 * tolerance);
  if (ratio->low > tolerance || ratio->high < -tolerance) return {Verdict::Fail, is};
  if (ratio->low >= -tolerance && ratio->high <= tolerance) return {Verdict::Pass, is};
  // The interval shrinks with the root of the samples, of image and reference alike, until it ends at the
  // nearer of the two limits.
  const double reach = ratio->high - ratio->value;
  const double distance = std::fabs(std::fabs(ratio->value) - tolerance);
  if (distance == 0) return {Verdict::Inconclusive, is + ": it lies on the limit"};
  return {Verdict::Inconclusive, fmt::format("{}: needs about {:.2g} times the samples, in the reference too",
                                             is, reach * reach / (distance * distance))};
}

}  // namespace orbs::runner
