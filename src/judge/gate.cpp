#include "judge/gate.h"

#include "base/error.h"
#include "base/statistics.h"
#include "base/two_digits.h"
#include "judge/noise.h"
#include "judge/sequential.h"
#include "metrics/describe.h"
#include "metrics/rare_light.h"
#include "metrics/residual.h"
#include "metrics/table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::judge {

namespace {

using metrics::Absence;
using metrics::GateRule;
using metrics::Limits;
using metrics::Measurement;
using results::Verdict;

// What noise does to psnr_srgb8, in squared steps of 1/255.
struct NoiseShare {
  double all = 0;           // of result and reference
  double of_reference = 0;  // stays when the result gets more samples
};

// Noise that is not stated is read off all pixels where no test sees a bias, for then the difference has no
// structure. Else where the reference is smooth, so that what goes wrong at edges does not pass for noise.
std::optional<NoiseShare> noise_share(const metrics::ImagePair& pair, bool is_biased) {
  const auto of_reference =
      noise_mse_srgb8(pair.reference_variance, pair.reference, pair.included).value_or(0);
  if (pair.noise_source == metrics::NoiseSource::Scatter) {
    const auto all = scatter_mse_srgb8(pair, is_biased ? metrics::smooth_pixels(pair) : pair.included);
    if (!all) return std::nullopt;
    return NoiseShare{std::max(*all, of_reference), std::min(*all, of_reference)};
  }
  const auto of_result = noise_mse_srgb8(pair.result_variance, pair.reference, pair.included).value_or(0);
  return NoiseShare{of_result + of_reference, of_reference};
}

// The noise of the result falls with its samples; that of the reference stays, and so does what noise does
// not explain.
std::string samples_needed(double mse, double allowed_mse, const NoiseShare& noise) {
  const double stays = std::max(0.0, mse - noise.all) + noise.of_reference;
  if (allowed_mse <= stays) return "the reference is too noisy for this gate";
  return fmt::format("needs about {} times the samples", two_digits((mse - stays) / (allowed_mse - stays)));
}

// A PSNR below `least` fails where the error misses it that is left when the noise of both images is taken
// away. Twice the noise where no test sees a bias: the tests are what finds a wrong image, and the delta
// method leaves out the bend and the clamp of the curve, 0.7 dB in a control image of edges and sky with 4
// samples. Where one does, those 0.7 dB.
GateResult check_missed_psnr(const std::string& missed,
                             double value,
                             double least,
                             const metrics::ImagePair& pair) {
  constexpr double kNoiseSlack = 2;
  constexpr double kNoiseSlackWhereBiased = 1.17;
  const bool is_biased = !metrics::bias_message(pair.noise).empty();
  const auto noise = noise_share(pair, is_biased);
  if (!noise || !(noise->all > 0)) return {Verdict::Fail, missed};
  const double explained = noise->all * (is_biased ? kNoiseSlackWhereBiased : kNoiseSlack);
  if (mse_srgb8_of(value) - explained > mse_srgb8_of(least)) return {Verdict::Fail, missed};
  return {Verdict::Inconclusive,
          fmt::format("{}, but noise alone gives {:.4g} dB: {}", missed, psnr_srgb8_of(noise->all),
                      samples_needed(mse_srgb8_of(value), mse_srgb8_of(least), *noise))};
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
  return {Verdict::Inconclusive, fmt::format("{}: needs about {} times the samples, in the reference too", is,
                                             two_digits(reach * reach / (distance * distance)))};
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

// A decibel is a ratio already.
double excess_over(const Measurement& measurement, const Limits& limits) {
  constexpr double kNothing = std::numeric_limits<double>::infinity();
  if (!measurement.value) return kNothing;
  const double value = *measurement.value;
  if (limits.min && !(value >= *limits.min)) {
    if (measurement.metric->unit == "dB") return std::pow(10, (*limits.min - value) / 20);
    return *limits.min < 0 ? value / *limits.min : value > 0 ? *limits.min / value : kNothing;
  }
  if (limits.max && *limits.max > 0) return value / *limits.max;
  return kNothing;
}

GateResult checked(const registry::Gate& gate,
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
    case GateRule::Certain:
    case GateRule::CertainShare:
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

}  // namespace

GateResult check_gate(const registry::Gate& gate,
                      const Measurement& measurement,
                      const metrics::ImagePair& pair,
                      double of_first_guess) {
  auto result = pair.looks > 1 && measurement.value
                    ? check_gate_at_look(gate, measurement, pair, of_first_guess)
                    : checked(gate, measurement, pair);
  if (result.verdict != Verdict::Pass) result.excess = excess_over(measurement, {gate.min, gate.max});
  return result;
}

void refuse_unknown_metrics(const registry::Case& one_case) {
  for (const auto& gate : one_case.gates)
    with_note(fmt::format("reading the gate at {}", gate.place), [&] { metrics::find_metric(gate.metric); });
}

using results::Check;
using results::Verdict;

namespace {

double pixels_of(const Rectangle& region) {
  return static_cast<double>(region.x1 - region.x0) * (region.y1 - region.y0);
}

std::array<double, 3> mean_of_region(const image::Image& image, const Rectangle& region) {
  std::array<double, 3> sum{};
  const std::array<int, 3> channels{image::channel_index(image, "R"), image::channel_index(image, "G"),
                                    image::channel_index(image, "B")};
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        sum.at(c) += static_cast<double>(image.at(x, y, static_cast<std::size_t>(channels.at(c))));
  const double count = pixels_of(region);
  for (auto& value : sum) value /= count;
  return sum;
}

bool states_noise(const image::Image& image) {
  return image::channel_index(image, "variance.R") >= 0 && variance_problem(image).empty();
}

// Where the image does not state its noise: half the mean square of the steps between neighbours is the
// variance of a pixel, where the light is even; where it is not, it is more. 0 in a region of one pixel.
std::array<double, 3> standard_errors_by_scatter(const image::Image& image, const Rectangle& region) {
  std::array<double, 3> errors{};
  const std::array<int, 3> channels{image::channel_index(image, "R"), image::channel_index(image, "G"),
                                    image::channel_index(image, "B")};
  double steps = 0;
  const auto add = [&](int x, int y, int u, int v) {
    if (u >= region.x1 || v >= region.y1) return;
    ++steps;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto channel = static_cast<std::size_t>(channels.at(c));
      const double step =
          static_cast<double>(image.at(u, v, channel)) - static_cast<double>(image.at(x, y, channel));
      errors.at(c) += step * step / 2;
    }
  };
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x) {
      add(x, y, x + 1, y);
      add(x, y, x, y + 1);
    }
  if (!(steps > 0)) return errors;
  const double count = pixels_of(region);
  for (auto& error : errors) error = std::sqrt(error / steps / count);
  return errors;
}

// Of the region's sum, as the noise of pixels is independent.
std::array<metrics::PooledVariance, 3> noise_of_region(const std::vector<float>& variances,
                                                       int width,
                                                       const Rectangle& region) {
  std::array<metrics::PooledVariance, 3> noise{};
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        noise.at(c).add(metrics::variance_at(variances, 3 * static_cast<std::size_t>(y * width + x) + c));
  return noise;
}

// Of the region's mean.
std::array<double, 3> standard_errors_of_region(const image::Image& image, const Rectangle& region) {
  if (!states_noise(image)) return standard_errors_by_scatter(image, region);
  std::array<double, 3> errors{};
  const auto noise = noise_of_region(image::select_rgb(image, "variance.").pixels, image.width, region);
  for (std::size_t c = 0; c < 3; ++c) errors.at(c) = std::sqrt(noise.at(c).sum) / pixels_of(region);
  return errors;
}

// How far noise may have moved the mean up and down: the standard errors of the check with the degrees of
// freedom that the region's few pixels have (noise_test.h), and down what the region may lack because no
// sample has found it (rare_light.h).
struct ReachOfRegion {
  std::array<double, 3> up{};
  std::array<double, 3> down{};
};

ReachOfRegion reach_of_region(const registry::PixelCheck& check, const image::Image& image) {
  constexpr double kNormal = 1e9;  // degrees of freedom
  ReachOfRegion reach;
  const auto errors = standard_errors_of_region(image, check.region);
  for (std::size_t c = 0; c < 3; ++c) reach.up.at(c) = check.standard_errors * errors.at(c);
  reach.down = reach.up;
  if (!(check.standard_errors > 0) || !states_noise(image)) return reach;
  const auto variances = image::select_rgb(image, "variance.").pixels;
  const auto noise = noise_of_region(variances, image.width, check.region);
  const auto hits = metrics::hit_size(variances, {});
  const double outside = student_tail(check.standard_errors, kNormal);
  for (std::size_t c = 0; c < 3; ++c) {
    reach.up.at(c) = student_quantile(outside, noise.at(c).degrees()) * errors.at(c);
    const double unseen = metrics::unseen_light(hits.at(c), noise.at(c), outside / 2);
    reach.down.at(c) =
        unseen > 0 ? std::max(reach.down.at(c), unseen / pixels_of(check.region)) : reach.up.at(c);
  }
  return reach;
}

// Samples that all were black have no scatter, and a standard error of 0 claims what they cannot know: light
// that one sample in a thousand finds is missing from most regions of a hundred samples. A region that should
// be black needs no such doubt.
bool is_black_by_chance(const registry::PixelCheck& check, const image::Image& image) {
  const std::array<double, 3> black{};
  return check.standard_errors > 0 && states_noise(image) && check.expected != black &&
         mean_of_region(image, check.region) == black &&
         standard_errors_of_region(image, check.region) == black;
}

}  // namespace

Check check_pixels(const registry::PixelCheck& check, const image::Image& image) {
  if (!check.not_measured.empty()) {
    const auto what = fmt::format("pixels {}", rectangle_text(check.region));
    return {what, false, fmt::format("{}: {}", what, check.not_measured), {}, {}, false};
  }
  const auto mean = mean_of_region(image, check.region);
  const auto errors = standard_errors_of_region(image, check.region);
  Check out{fmt::format("pixels {}", rectangle_text(check.region)), true, "", {}, {}};
  for (std::size_t c = 0; c < 3; ++c)
    out.passed =
        out.passed && std::fabs(mean.at(c) - check.expected.at(c)) + check.standard_errors * errors.at(c) <=
                          check.tolerance;
  const auto noise = check.standard_errors > 0 ? fmt::format(" with {:.3g} standard errors of ({:.2g})",
                                                             check.standard_errors, fmt::join(errors, ", "))
                                               : "";
  out.reason =
      fmt::format("{} have the linear mean ({:.6g}){}, expected ({:.6g}) within {} ({})", out.what,
                  fmt::join(mean, ", "), noise, fmt::join(check.expected, ", "), check.tolerance, check.why);
  if (is_black_by_chance(check, image))
    out.reason += "; all its samples are black: the light is missing, or so rare that it needs more samples";
  return out;
}

Verdict verdict_of_missed_check(const registry::PixelCheck& check, const image::Image& image) {
  const auto mean = mean_of_region(image, check.region);
  if (is_black_by_chance(check, image)) return Verdict::Inconclusive;
  const auto reach = reach_of_region(check, image);
  for (std::size_t c = 0; c < 3; ++c) {
    const double off = mean.at(c) - check.expected.at(c);
    if (std::fabs(off) - (off < 0 ? reach.down : reach.up).at(c) > check.tolerance) return Verdict::Fail;
  }
  return Verdict::Inconclusive;
}

double excess_of_missed_check(const registry::PixelCheck& check, const image::Image& image) {
  const auto mean = mean_of_region(image, check.region);
  double farthest = 0;
  for (std::size_t c = 0; c < 3; ++c)
    farthest = std::max(farthest, std::fabs(mean.at(c) - check.expected.at(c)));
  return check.tolerance > 0 ? farthest / check.tolerance : std::numeric_limits<double>::infinity();
}

}  // namespace orbs::judge
