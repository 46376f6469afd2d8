#include "judge/gate.h"

#include "base/error.h"
#include "judge/noise.h"
#include "metrics/bias_message.h"
#include "metrics/describe.h"
#include "metrics/table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace orbs::judge {

namespace {

using metrics::Absence;
using metrics::GateRule;
using metrics::Limits;
using metrics::Measurement;
using results::Verdict;

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

// A PSNR below `least`: Inconclusive where the noise of both images explains it and no test sees a bias.
GateResult check_missed_psnr(const std::string& missed,
                             double value,
                             double least,
                             const metrics::ImagePair& pair) {
  const auto result_mse = noise_mse_srgb8(pair.result_variance, pair.reference, pair.included);
  const auto reference_mse = noise_mse_srgb8(pair.reference_variance, pair.reference, pair.included);
  if (!result_mse && !reference_mse) return {Verdict::Fail, missed};
  const double expected_db = psnr_srgb8_of(result_mse.value_or(0) + reference_mse.value_or(0));
  if (value < expected_db - kNoiseSlack_db) return {Verdict::Fail, missed};
  // A right image with this noise would measure the same, but would show no bias.
  if (const auto bias = metrics::bias_message(pair.noise); !bias.empty())
    return {Verdict::Fail, fmt::format("{}; {}", missed, bias)};
  const auto noise_alone =
      std::isinf(expected_db) ? std::string("infinite") : fmt::format("{:.4g} dB", expected_db);
  return {Verdict::Inconclusive,
          fmt::format("{}, but noise alone gives {}: {}", missed, noise_alone,
                      samples_needed(mse_srgb8_of(value), mse_srgb8_of(least), reference_mse.value_or(0)))};
}

// The interval shrinks with the root of the samples, of image and reference alike, until it ends at the
// nearer of the two limits.
GateResult undecided_interval(const std::string& is, const Measurement& measurement, const Limits& limits) {
  const double value = *measurement.value;
  double distance = std::numeric_limits<double>::infinity();
  for (const auto& limit : {limits.min, limits.max})
    if (limit) distance = std::min(distance, std::fabs(value - *limit));
  if (distance == 0) return {Verdict::Inconclusive, is + ": it lies on the limit"};
  const double reach = measurement.high.value_or(value) - value;
  return {Verdict::Inconclusive, fmt::format("{}: needs about {:.2g} times the samples, in the reference too",
                                             is, reach * reach / (distance * distance))};
}

Verdict verdict_of(Absence absence) {
  switch (absence) {
    case Absence::Undefined:
      return Verdict::Inconclusive;
    case Absence::NothingInReference:
      return Verdict::Pass;
    case Absence::MissingInResult:
      return Verdict::Fail;
  }
  return Verdict::Inconclusive;
}

}  // namespace

GateResult check_gate(const registry::Gate& gate,
                      const Measurement& measurement,
                      const metrics::ImagePair& pair) {
  const Limits limits{gate.min, gate.max};
  const auto is = metrics::describe(measurement, limits);
  if (!measurement.value) return {verdict_of(measurement.absence), is};
  const double value = *measurement.value;
  const double low = measurement.low.value_or(value);
  const double high = measurement.high.value_or(value);
  const bool reaches = (!gate.max || low <= *gate.max) && (!gate.min || high >= *gate.min);
  switch (measurement.metric->rule) {
    case GateRule::Value:
      break;
    case GateRule::WholeInterval:
      if (!reaches) return {Verdict::Fail, is};
      if (metrics::is_within(low, limits) && metrics::is_within(high, limits)) return {Verdict::Pass, is};
      return undecided_interval(is, measurement, limits);
    case GateRule::AnyOfInterval:
      return {reaches ? Verdict::Pass : Verdict::Fail, is};
    case GateRule::NoiseAware:
      if (gate.min && !(value >= *gate.min)) return check_missed_psnr(is, value, *gate.min, pair);
      break;
  }
  return {metrics::is_within(value, limits) ? Verdict::Pass : Verdict::Fail, is};
}

void refuse_unknown_metrics(const registry::Case& one_case) {
  for (const auto& gate : one_case.gates)
    with_note(fmt::format("reading the gate at {}", gate.place), [&] { metrics::find_metric(gate.metric); });
}

}  // namespace orbs::judge
