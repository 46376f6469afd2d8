#include "run/accepted_number.h"

#include "results/least_change.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

namespace orbs::run {

namespace {

using results::Check;
using results::Measure;
using results::TargetRecord;

bool is_two_sided(const Check& check) { return check.min && check.max; }

// The right value of a number that is no PSNR.
double right_value(const Check& check) {
  if (is_two_sided(check)) return (*check.min + *check.max) / 2;
  return check.max ? 0 : 1;
}

double mse_of(double psnr_db) { return std::pow(10, -psnr_db / 10); }

double error_of(double value, const std::string& unit, const Check& check) {
  return unit == "dB" ? mse_of(value) : std::fabs(value - right_value(check));
}

// Half the interval of the mean squared error, in shares of it.
double relative_noise(const TargetRecord& target) {
  const auto* mse = measure_of(target, "mse");
  const auto* bias = measure_of(target, "bias_squared");
  if (mse == nullptr || bias == nullptr || !bias->low || !bias->high || !(mse->value > 0)) return 0;
  return (*bias->high - *bias->low) / 2 / mse->value;
}

// Half the interval of the error.
double noise_of(const Measure& measure, const TargetRecord& target) {
  if (measure.unit == "dB") return relative_noise(target) * mse_of(measure.value);
  if (measure.low && measure.high) return (*measure.high - *measure.low) / 2;
  if (measure.name != "local_bias") return 0;
  const auto* hidden = measure_of(target, "smallest_error_16px");
  return hidden != nullptr && std::isfinite(hidden->value) ? hidden->value : 0;
}

bool is_on_other_side(double accepted, const Measure& measure, const Check& check) {
  if (!is_two_sided(check)) return false;
  const double right = right_value(check);
  const double low = measure.low.value_or(measure.value);
  const double high = measure.high.value_or(measure.value);
  return accepted > right ? high < right : accepted < right && low > right;
}

// 'R' of "mean_ratio_r", 0 of another check.
char channel_of_mean(const Check& check) {
  constexpr std::string_view kMean = "mean_ratio_";
  if (check.what.size() != kMean.size() + 1 || !check.what.starts_with(kMean)) return 0;
  return static_cast<char>(std::toupper(static_cast<unsigned char>(check.what.back())));
}

}  // namespace

const Measure* measure_of(const TargetRecord& target, const std::string& name) {
  const auto found = std::find_if(target.measures.begin(), target.measures.end(),
                                  [&](const Measure& measure) { return measure.name == name; });
  return found == target.measures.end() ? nullptr : &*found;
}

AcceptedChange compare_with_accepted(double accepted,
                                     const Check& check,
                                     const TargetRecord& target,
                                     double tolerance) {
  const auto* measure = measure_of(target, check.what);
  if (measure == nullptr) return AcceptedChange::Worse;
  if (!check.passed && is_on_other_side(accepted, *measure, check)) return AcceptedChange::OtherSide;
  const double now = error_of(measure->value, measure->unit, check);
  const double before = error_of(accepted, measure->unit, check);
  const double least = std::max({std::numbers::sqrt2 * noise_of(*measure, target), tolerance * before,
                                 measure->unit == "dB" ? 0 : results::kLeastLight});
  // Written so that a number that is none is worse.
  if (!(now <= before + least)) return AcceptedChange::Worse;
  return now < before - least ? AcceptedChange::Better : AcceptedChange::Within;
}

std::string number_text(double number, const Check& check) {
  if (channel_of_mean(check) != 0)
    return fmt::format("{:.3g} % {}", 100 * std::fabs(number), number < 0 ? "darker" : "brighter");
  if (check.what == "psnr_srgb8") return fmt::format("{:.4g} dB", number);
  return is_two_sided(check) ? fmt::format("{:+.5g}", number) : fmt::format("{:.5g}", number);
}

std::string number_said(double number, const Check& check) {
  const char channel = channel_of_mean(check);
  const auto name = channel != 0                 ? std::string(1, channel)
                    : check.what == "psnr_srgb8" ? std::string("the PSNR")
                                                 : check.what;
  return fmt::format("{} is {}", name, number_text(number, check));
}

}  // namespace orbs::run
