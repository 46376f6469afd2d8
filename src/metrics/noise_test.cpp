#include "metrics/noise_test.h"

#include "base/statistics.h"
#include "metrics/common_noise.h"
#include "metrics/shared_noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace orbs::metrics {

namespace {

constexpr double kPerTest = kFalseAlarms / kTests;
constexpr double kPerNearTest = 1e-6;  // what it says sounds like an accusation
// Three tests of one side each, of the two sides of an interval.
constexpr double kPerNoiseTest = kPerTest * 2 / 3;

struct Totals {
  double result = 0;
  double reference = 0;
};

Totals totals_of(const PairSamples& samples, std::size_t channel) {
  Totals totals;
  for (std::size_t pixel = 0; pixel < samples.included.size(); ++pixel) {
    if (samples.included[pixel] == 0) continue;
    totals.result += static_cast<double>(samples.result[3 * pixel + channel]);
    totals.reference += static_cast<double>(samples.reference[3 * pixel + channel]);
  }
  return totals;
}

struct RatioVariance {
  PooledVariance pooled;
  double of_reference = 0;
};

// Variance of sum(result - ratio * reference), the numerator of the ratio's error by the delta method.
RatioVariance from_variances(const PairSamples& samples,
                             std::size_t channel,
                             double ratio,
                             const std::array<double, 3>& variance_ratio) {
  DifferenceVariance variance(samples, channel, ratio, variance_ratio);
  for (std::size_t pixel = 0; pixel < samples.included.size(); ++pixel)
    if (samples.included[pixel] != 0) variance.add(pixel);
  return {variance.pooled(), variance.of_reference()};
}

// The same from the sums of blocks in pairs as they are read, neighbours but for those that end a row and
// begin the next: (A - B)^2, whose expectation is the variance of both where the error is noise, and more
// where it has structure. Whole blocks, so that a filter that reaches over a
// pixel's border hides little. A last block without a neighbour is taken to be like the others.
PooledVariance from_scatter(const PairSamples& samples, std::size_t channel, double ratio) {
  std::vector<double> sums;
  for (const Rectangle& block : blocks_of(samples)) {
    double sum = 0;
    for_each_block_pixel(samples, block, [&](std::size_t pixel) {
      const std::size_t i = 3 * pixel + channel;
      sum += static_cast<double>(samples.result[i]) - ratio * static_cast<double>(samples.reference[i]);
    });
    sums.push_back(sum);
  }
  PooledVariance pooled;
  for (std::size_t i = 0; i + 1 < sums.size(); i += 2)
    pooled.add((sums[i] - sums[i + 1]) * (sums[i] - sums[i + 1]));
  const std::size_t paired = sums.size() - sums.size() % 2;
  const double scale = static_cast<double>(sums.size()) / static_cast<double>(paired);
  return {pooled.sum * scale, pooled.squares * scale * scale};
}

// By the noise that pixels have in common, over areas and all of them, and by the light that no sample has
// found: what is too dark lacks so much at most.
void widen(const PairSamples& samples, std::size_t channel, const Totals& totals, Interval& ratio) {
  const double count = static_cast<double>(samples.included_count);
  const double over_areas = (ratio.high - ratio.value) * std::sqrt(samples.area_noise.over_16px.at(channel));
  const double reach = std::max(over_areas, common_reach(samples, channel) * count / totals.reference);
  ratio.low = ratio.value - reach;
  ratio.high = ratio.value + std::max(reach, samples.unseen_share);
}

std::optional<MeanRatio> ratio_of(const PairSamples& samples, std::size_t channel) {
  constexpr double kFirmness = 10;  // the delta method is first order: the divisor must stand firm
  const Totals totals = totals_of(samples, channel);
  double reference_variance = 0;
  for (std::size_t pixel = 0; pixel < samples.included.size(); ++pixel)
    if (samples.included[pixel] != 0)
      reference_variance += variance_at(samples.reference_variance, 3 * pixel + channel);
  if (!(totals.reference > kFirmness * std::sqrt(reference_variance))) return std::nullopt;
  const double ratio = totals.result / totals.reference;
  const bool is_scatter = samples.noise_source == NoiseSource::Scatter;
  if (is_scatter && blocks_of(samples).size() < 2) return std::nullopt;
  const auto variance_by = [&](const std::array<double, 3>& variance_ratio) {
    return is_scatter ? RatioVariance{from_scatter(samples, channel, ratio)}
                      : from_variances(samples, channel, ratio, variance_ratio);
  };
  const auto interval_by = [&](const RatioVariance& variance, double outside) {
    return student_interval(ratio - 1, std::sqrt(variance.pooled.sum) / totals.reference,
                            variance.pooled.degrees(), outside);
  };
  const auto counted = variance_by(samples.variance_ratio);
  auto whole = interval_by(counted, kPerTest / 3 / samples.looks);
  if (samples.looks == 1) return MeanRatio{whole, whole};
  const double reach_of_pixels = whole.high - whole.value;
  widen(samples, channel, totals, whole);
  auto seen = variance_by(samples.seen_variance_ratio);
  seen.pooled.scale(samples.area_noise.over_16px.at(channel));
  const double share = seen.pooled.sum > 0 ? std::min(1.0, seen.of_reference / seen.pooled.sum) : 0.0;
  auto to_pass = interval_by(seen, 2 * kWrongPasses / samples.looks);
  const double in_common = kErrorsToPass * samples.common_noise.error.at(channel) *
                           static_cast<double>(samples.included_count) / totals.reference;
  to_pass.low = std::min(to_pass.low, to_pass.value - in_common);
  to_pass.high = std::max(to_pass.high, to_pass.value + in_common);
  return MeanRatio{whole, to_pass, share, reach_of_pixels};
}

// Mean of independent numbers; their scatter also holds that of the errors themselves, which only makes the
// interval wider.
Interval mean_of(const std::vector<double>& values, double false_alarms) {
  const auto count = static_cast<double>(values.size());
  double mean = 0;
  for (const double value : values) mean += value / count;
  PooledVariance scatter;
  for (const double value : values) scatter.add((value - mean) * (value - mean));
  return student_interval(mean, std::sqrt(scatter.sum) / count, scatter.degrees(), false_alarms);
}

// The variances of both images over all channels; which of the two estimates of the result's is chosen as
// in DifferenceVariance, for the same reason.
struct PixelVariances {
  std::vector<double> reference, own, expected;  // sums of the three channels of the chosen pixels
  double own_sum = 0, expected_sum = 0;
};

PixelVariances pixel_variances(const PairSamples& samples, const std::vector<std::uint8_t>& chosen) {
  PixelVariances all;
  for (auto* sums : {&all.reference, &all.own, &all.expected}) sums->reserve(samples.included_count);
  for (std::size_t pixel = 0; pixel < chosen.size(); ++pixel) {
    if (chosen[pixel] == 0) continue;
    double reference = 0;
    double own = 0;
    double expected = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double of_reference = variance_at(samples.reference_variance, 3 * pixel + c);
      reference += of_reference;
      own += variance_at(samples.result_variance, 3 * pixel + c) + of_reference;
      expected += (samples.variance_ratio.at(c) + 1) * of_reference;
    }
    all.reference.push_back(reference);
    all.own.push_back(own);
    all.expected.push_back(expected);
    all.own_sum += own;
    all.expected_sum += expected;
  }
  return all;
}

// By pixel, over its channels.
std::vector<double> squared_differences(const PairSamples& samples) {
  std::vector<double> squares(samples.pixel_count());
  for (std::size_t pixel = 0; pixel < squares.size(); ++pixel)
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
      squares[pixel] += samples.difference(i) * samples.difference(i);
  return squares;
}

// (result - reference)^2 - variances has the expectation bias^2. The mean of its channels, which are far from
// independent, is one number per pixel.
Interval mean_excess(const std::vector<double>& squares,
                     const std::vector<std::uint8_t>& chosen,
                     const std::vector<double>& variances,
                     double false_alarms) {
  std::vector<double> excess(variances.size());
  std::size_t count = 0;
  for (std::size_t pixel = 0; pixel < chosen.size(); ++pixel) {
    if (chosen[pixel] == 0) continue;
    excess[count] = (squares[pixel] - variances[count]) / 3;
    ++count;
  }
  return mean_of(excess, false_alarms);
}

double mean_square(const PairSamples& samples, const std::vector<std::uint8_t>& chosen) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t pixel = 0; pixel < chosen.size(); ++pixel) {
    if (chosen[pixel] == 0) continue;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
      sum += static_cast<double>(samples.reference[i]) * static_cast<double>(samples.reference[i]);
    count += 3;
  }
  return sum / static_cast<double>(count);
}

double edge_square(const PairSamples& samples) {
  constexpr double kEdge_px = 0.15;
  double sum = 0;
  std::vector<double> steps;
  std::size_t pixel = 0;
  for (int y = 0; y < samples.height; ++y) {
    reference_steps(samples, y, steps);
    for (std::size_t i = 0; i < steps.size(); i += 3, ++pixel) {
      if (samples.included[pixel] == 0) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const double error = kEdge_px * steps[i + c];
        sum += error * error;
      }
    }
  }
  return sum / (3 * static_cast<double>(samples.included_count));
}

void split_by_variances(const PairSamples& samples,
                        const std::vector<double>& squares,
                        const PixelVariances& all,
                        const std::vector<std::uint8_t>& smooth,
                        NoiseTest& test) {
  const bool is_own = all.own_sum >= all.expected_sum;
  test.noise_squared = std::max(all.own_sum, all.expected_sum) / (3 * static_cast<double>(all.own.size()));
  const double outside = kPerTest / samples.looks;
  test.bias_squared = mean_excess(squares, samples.included, is_own ? all.own : all.expected, outside);
  if (std::count(smooth.begin(), smooth.end(), 1) < kFewestSmoothPixels) return;
  const PixelVariances there = pixel_variances(samples, smooth);
  const auto& variances = there.own_sum >= there.expected_sum ? there.own : there.expected;
  test.smooth = {mean_excess(squares, smooth, variances, outside), mean_square(samples, smooth)};
}

// Whether the squared differences are below half of these variances for sure. Half, as the variances of
// references are stored to 2 significant bits, which can make them a fifth too large.
bool is_less_than_half(const PairSamples& samples,
                       const std::vector<double>& squares,
                       std::vector<double> variances) {
  double sum = 0;
  for (double& variance : variances) {
    variance /= 2;
    sum += variance;
  }
  return sum > 0 && mean_excess(squares, samples.included, variances, kPerNoiseTest / samples.looks).high < 0;
}

StatedNoise check_stated_noise(const PairSamples& samples,
                               const std::vector<double>& squares,
                               const PixelVariances& all) {
  if (is_less_than_half(samples, squares, all.reference)) return StatedNoise::NearerThanReference;
  if (is_less_than_half(samples, squares, all.own)) return StatedNoise::OverstatedByResult;
  return StatedNoise::Plausible;
}

// The product of the differences of two neighbours has the expectation of the product of their biases, and
// half the square of their distance that of the noise, both where neighbours have the same bias.
void split_by_scatter(const PairSamples& samples, NoiseTest& test) {
  std::vector<double> products;
  double noise = 0;
  for_each_pair(samples, {0, 0, samples.width, samples.height},
                [&](std::size_t pixel, std::size_t neighbour) {
                  double product = 0;
                  for (std::size_t c = 0; c < 3; ++c) {
                    const double a = samples.difference(3 * pixel + c);
                    const double b = samples.difference(3 * neighbour + c);
                    product += a * b / 3;
                    noise += (a - b) * (a - b) / 6;
                  }
                  products.push_back(product);
                });
  if (products.empty()) return;
  test.noise_squared = noise / static_cast<double>(products.size());
  test.bias_squared = mean_of(products, kPerTest / samples.looks);
}

}  // namespace

NoiseTest test_noise(const PairSamples& samples) {
  NoiseTest test;
  test.source = samples.noise_source;
  const PixelVariances variances = pixel_variances(samples, samples.included);
  const auto squares = squared_differences(samples);
  test.stated = check_stated_noise(samples, squares, variances);
  for (std::size_t channel = 0; channel < 3; ++channel)
    test.mean_ratio.at(channel) = ratio_of(samples, channel);
  test.reference_squared = mean_square(samples, samples.included);
  test.edge_squared = edge_square(samples);
  const auto smooth = smooth_pixels(samples);
  if (test.source == NoiseSource::Scatter) {
    split_by_scatter(samples, test);
  } else {
    split_by_variances(samples, squares, variances, smooth, test);
  }
  const double per_test = kPerTest / samples.looks;
  test.blocks = score_blocks(samples, per_test);
  test.windows = window_errors(samples);
  test.line = line_error(samples);
  test.patterns = find_patterns(samples, per_test);
  test.correlation = strongest_correlation(samples, smooth, per_test);
  test.near_areas = near_areas(samples, kPerNearTest / samples.looks);
  test.shared_noise = shared_noise(samples, smooth, kPerNoiseTest / samples.looks);
  if (test.source == NoiseSource::Variances) test.pixels = score_pixels(samples);
  return test;
}

NoiseTest test_noise(const image::Image& result,
                     const image::Image& reference,
                     const Mask& mask,
                     ResultNoise result_noise) {
  return test_noise(pair_samples(result, reference, mask, result_noise));
}

std::optional<Interval> mean_error(const NoiseTest& test) {
  std::optional<Interval> worst;
  for (const auto& ratio : test.mean_ratio) {
    if (!ratio || (ratio->low <= kNegligible && ratio->high >= -kNegligible)) continue;
    if (!worst || std::fabs(ratio->value) > std::fabs(worst->value)) worst = ratio;
  }
  return worst;
}

bool is_square_biased(const NoiseTest& test) {
  return test.bias_squared.low > kNegligible * kNegligible * test.reference_squared;
}

bool is_square_biased_beyond_edges(const NoiseTest& test) {
  return is_square_biased(test) && test.bias_squared.low > test.edge_squared;
}

bool holds_reference_noise(const NoiseTest& test) {
  constexpr double kMost = 0.15;  // detail and contrast that is off by a tenth may look like less
  return test.shared_noise && test.shared_noise->low > kMost;
}

bool is_residual(const NoiseTest& test) {
  constexpr double kNegligibleResidual =
      3e-3;  // of the root mean square: rounding to 8 bits makes a third of it
  return test.smooth && test.smooth->bias_squared.low >
                            kNegligibleResidual * kNegligibleResidual * test.smooth->reference_squared;
}

}  // namespace orbs::metrics
