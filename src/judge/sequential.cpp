#include "judge/sequential.h"

#include "base/statistics.h"
#include "judge/noise.h"
#include "judge/psnr_bias.h"
#include "metrics/describe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace orbs::judge {

namespace {

using metrics::GateRule;
using metrics::Limits;
using metrics::Measurement;
using results::Verdict;

constexpr double kStandardErrorsAtBest = 2;
constexpr double kEdgeBelow = 0.85;
constexpr double kEdgeAbove = 1.15;

// How many times the samples an interval of this half-width needs to fit into the distance: its square has a
// part that falls with them, and the share of the reference, which stays.
double times_samples(double half_width, double distance, double reference_share) {
  if (!(distance > 0)) return Need::kNever;
  const double wanted = distance * distance / (half_width * half_width);
  if (wanted <= reference_share) return Need::kNever;
  return std::max(1.0, (1 - reference_share) / (wanted - reference_share));
}

// How far `value` lies within the limits; below 0 beyond one of them.
double distance_within(double value, const Limits& limits) {
  double distance = std::numeric_limits<double>::infinity();
  if (limits.max) distance = std::min(distance, *limits.max - value);
  if (limits.min) distance = std::min(distance, value - *limits.min);
  return distance;
}

bool is_edge(double low, double high, const Limits& limits) {
  for (const auto& limit : {limits.min, limits.max}) {
    if (!limit || *limit == 0) continue;
    const double a = low / *limit;
    const double b = high / *limit;
    if (std::min(a, b) >= kEdgeBelow && std::max(a, b) <= kEdgeAbove) return true;
  }
  return false;
}

// No error is smaller than none: at best it lies in the middle of the limits.
double most_within(const Limits& limits) {
  return limits.min && limits.max ? (*limits.max - *limits.min) / 2 : std::numeric_limits<double>::infinity();
}

Need need_of(const Measurement& measurement, const Limits& limits) {
  const double value = *measurement.value;
  const auto& to_pass = *measurement.to_pass;
  const double to_pass_width = (to_pass.high - to_pass.low) / 2;
  const double to_fail_width = to_pass.reach_to_fail > 0
                                   ? to_pass.reach_to_fail
                                   : (measurement.high.value_or(value) - measurement.low.value_or(value)) / 2;
  // The interval of a pass is 3.8 standard errors wide to either side, or Student's, which is wider.
  const double nearer = kStandardErrorsAtBest * to_pass_width / 3.8;
  const double distance = distance_within(value, limits);
  const double share = to_pass.reference_share;
  Need need;
  need.samples = distance > 0 ? times_samples(to_pass_width, distance, share)
                              : times_samples(to_fail_width, -distance, share);
  need.at_best =
      std::min(times_samples(to_pass_width, std::min(most_within(limits), distance + nearer), share),
               times_samples(to_fail_width, nearer - distance, share));
  need.is_reference = std::isinf(need.at_best);
  need.is_edge = is_edge(measurement.low.value_or(value), measurement.high.value_or(value), limits);
  return need;
}

GateResult check_interval(const std::string& is, const Measurement& measurement, const Limits& limits) {
  const double value = *measurement.value;
  const double low = measurement.low.value_or(value);
  const double high = measurement.high.value_or(value);
  const auto& to_pass = *measurement.to_pass;
  GateResult result{.reason = is, .value = value, .low = to_pass.low, .high = to_pass.high};
  if ((limits.max && low > *limits.max) || (limits.min && high < *limits.min)) {
    result.verdict = Verdict::Fail;
    result.low = low;
    result.high = high;
  } else if (!metrics::is_within(to_pass.low, limits) || !metrics::is_within(to_pass.high, limits)) {
    result.verdict = Verdict::Inconclusive;
    result.need = need_of(measurement, limits);
    if (to_pass.reach_to_fail > 0 && -distance_within(value, limits) > to_pass.reach_to_fail) {
      result.need->awaits_looks = true;
      result.reason += "; too few looks to tell what noise its pixels have in common";
    }
  }
  return result;
}

// Of what is certain of an error; `to_pass`, if there, ends at what it may be at most.
GateResult check_certain(const std::string& is,
                         const Measurement& measurement,
                         const Limits& limits,
                         double certain_share) {
  const double value = *measurement.value;
  GateResult result{.reason = is, .value = value, .low = value};
  if (!metrics::is_within(value, limits)) {
    result.verdict = Verdict::Fail;
    return result;
  }
  if (!measurement.to_pass || !limits.max) return result;
  const double most = measurement.to_pass->high;
  result.high = most;
  const double allowed = *limits.max / certain_share;
  if (most <= allowed) return result;
  result.verdict = Verdict::Inconclusive;
  // Nearly all of it is noise, or what is certain would be more than nothing.
  const double times = most * most / (allowed * allowed);
  result.need =
      Need{.samples = times, .at_best = times, .is_edge = is_edge(value, most, {limits.min, allowed})};
  result.reason = fmt::format("{}; noise hides up to {:.3g} %", is, 100 * most);
  return result;
}

GateResult check_number(const std::string& is,
                        const Measurement& measurement,
                        const Limits& limits,
                        double of_first_guess) {
  GateResult result{.reason = is, .value = measurement.value};
  if (metrics::is_within(*measurement.value, limits)) return result;
  result.verdict = of_first_guess < 1 ? Verdict::Inconclusive : Verdict::Fail;
  if (of_first_guess < 1) result.need = Need{.samples = 1 / of_first_guess, .at_best = 1 / of_first_guess};
  return result;
}

// What decides a PSNR of at least `least`, in squared steps of 1/255.
struct PsnrTest {
  PsnrBias bias;
  double allowed = 0;
  double to_fail = 0;  // reach of the bias
  double to_pass = 0;
  double widening = 1;  // of the former, see widening_of
};

// Noise above these multiples of the error that is allowed bends the curve too much for the product of
// halves: at 25 dB for a limit of 35 dB a bias of 7 % of the noise is certain to be an error, at 28 dB what
// is left of the bend is too little to matter.
constexpr double kMostNoiseToFail = 10;
constexpr double kMostNoiseToPass = 5;
constexpr double kBend = 0.07;

bool is_psnr_missed(const PsnrTest& test) {
  return test.bias.expected_noise <= kMostNoiseToFail * test.allowed &&
         test.bias.squared - test.widening * test.to_fail - kBend * test.bias.expected_noise > test.allowed;
}

bool is_psnr_met(const PsnrTest& test) {
  return test.bias.noise <= kMostNoiseToPass * test.allowed &&
         test.bias.squared + test.to_pass < test.allowed;
}

// The noise falls with the samples, and so does the reach of the product, but for the reference's part.
Need need_of(const PsnrTest& test) {
  const auto& bias = test.bias;
  const double of_result = std::max(0.0, bias.noise - bias.reference_noise);
  const auto times_noise = [&](double multiple) {
    const double left = multiple * test.allowed - bias.reference_noise;
    return left > 0 ? std::max(1.0, of_result / left) : Need::kNever;
  };
  const auto times_reach = [&](double reach, double distance) {
    return distance > 0 ? std::max(1.0, reach / distance) : Need::kNever;
  };
  const double error = bias.standard_error * kStandardErrorsAtBest;
  const double within = test.allowed - bias.squared;
  // Without the noise, or with it when there is little enough.
  const auto to_pass = [&](double distance) {
    const double multiple = std::min(1.0, distance / test.allowed);
    return std::min(std::max(times_noise(kMostNoiseToPass), times_reach(test.to_pass, distance)),
                    times_noise(multiple));
  };
  const auto to_fail = [&](double distance) {
    return std::max(times_noise(kMostNoiseToFail), times_reach(test.to_fail, distance));
  };
  Need need;
  need.samples = within > 0 ? to_pass(within) : to_fail(-within);
  need.at_best = std::min(to_pass(std::min(test.allowed, within + error)), to_fail(error - within));
  need.is_reference = std::isinf(need.at_best);
  const double low = bias.squared - test.to_fail;
  const double high = bias.squared + test.to_fail;
  need.is_edge =
      low >= kEdgeBelow * kEdgeBelow * test.allowed && high <= kEdgeAbove * kEdgeAbove * test.allowed;
  return need;
}

double psnr_without_noise(double squared, double standard_errors) {
  return psnr_srgb8_of(std::max(0.0, squared + standard_errors));
}

// How much wider what pixels have in common makes the interval of the mean than their own noise does, and so
// that of the product of the halves, whose blocks are then no independent numbers either.
double widening_of(const metrics::ImagePair& pair) {
  double widening = 1;
  for (const auto& ratio : pair.noise.mean_ratio)
    if (ratio && ratio->reach_of_pixels > 0)
      widening = std::max(widening, (ratio->value - ratio->low) / ratio->reach_of_pixels);
  return widening;
}

// Where the noise happened to take more off the product than the error adds, no number can be said.
std::string above_without_noise(double low_db) {
  if (low_db < 0) return "too few pixels to tell it without noise";
  return std::isinf(low_db) ? "no error is seen without its noise"
                            : fmt::format("without noise above {:.1f} dB", low_db);
}

GateResult check_psnr(const std::string& is,
                      const Measurement& measurement,
                      double least_db,
                      const metrics::ImagePair& pair) {
  PsnrTest test{*psnr_bias(pair), mse_srgb8_of(least_db)};
  const auto reach = [&](double one_side) {
    return student_interval(0, test.bias.standard_error, test.bias.degrees, 2 * one_side / pair.looks).high;
  };
  test.to_fail = reach(metrics::kWrongFails);
  test.widening = widening_of(pair);
  test.to_pass = reach(metrics::kWrongPasses);
  const double low_db = psnr_without_noise(test.bias.squared, test.to_pass);
  GateResult result{.reason = is, .value = measurement.value, .low = low_db};
  const double high_square = test.bias.squared - test.widening * test.to_fail;
  if (high_square > 0) result.high = psnr_srgb8_of(high_square);
  if (*measurement.value >= least_db) return result;
  if (is_psnr_missed(test)) {
    result.verdict = Verdict::Fail;
    result.reason =
        fmt::format("psnr_srgb8 is below {:.1f} dB without noise, at least {} is needed; {:.2f} dB with it",
                    result.high.value_or(least_db), least_db, *measurement.value);
    return result;
  }
  // The number that the verdict rests on leads: 34.6 dB beside a pass would look like a mistake.
  if (is_psnr_met(test)) {
    result.reason =
        std::isinf(low_db)
            ? fmt::format("{}; {}", is, above_without_noise(low_db))
            : fmt::format(
                  "psnr_srgb8 is above {:.1f} dB without noise, at least {} is needed; {:.2f} dB with it",
                  low_db, least_db, *measurement.value);
    return result;
  }
  result.reason = fmt::format("{}; {}", is, above_without_noise(low_db));
  result.verdict = Verdict::Inconclusive;
  result.need = need_of(test);
  return result;
}

}  // namespace

GateResult check_gate_at_look(const registry::Gate& gate,
                              const Measurement& measurement,
                              const metrics::ImagePair& pair,
                              double of_first_guess) {
  const Limits limits{gate.min, gate.max};
  const auto is = metrics::describe(measurement, limits);
  const auto decide = [&] {
    switch (measurement.metric->rule) {
      case GateRule::Certain:
        return check_certain(is, measurement, limits, 1);
      case GateRule::CertainShare:
        return check_certain(is, measurement, limits, metrics::kCertainShare);
      case GateRule::WholeInterval:
      case GateRule::AnyOfInterval:
        if (measurement.to_pass) return check_interval(is, measurement, limits);
        break;
      case GateRule::NoiseAware:
        if (gate.min && !pair.half_display[0].empty()) return check_psnr(is, measurement, *gate.min, pair);
        break;
      case GateRule::Value:
        break;
    }
    return check_number(is, measurement, limits, of_first_guess);
  };
  auto result = decide();
  result.gate = gate.metric;
  return result;
}

}  // namespace orbs::judge
