#include "metrics/stokes.h"

#include "image/colour.h"
#include "metrics/amplitude.h"
#include "metrics/describe.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace orbs::metrics {

namespace {

double luminance_of(const std::vector<float>& rgb, std::size_t pixel) {
  return image::luminance(static_cast<double>(rgb[3 * pixel]), static_cast<double>(rgb[3 * pixel + 1]),
                          static_cast<double>(rgb[3 * pixel + 2]));
}

// Mean square of the block means of a - b, weighted by their counted pixels.
double mean_square_of_blocks(const PairSamples& samples,
                             const std::vector<float>& a,
                             const std::vector<float>& b) {
  double squares = 0;
  for (const Rectangle& block : blocks_of(samples)) {
    double sum = 0;
    double count = 0;
    for_each_block_pixel(samples, block, [&](std::size_t pixel) {
      sum += luminance_of(a, pixel) - luminance_of(b, pixel);
      ++count;
    });
    if (count > 0) squares += sum * sum / count;
  }
  return squares / static_cast<double>(samples.included_count);
}

// Of one parameter and block: ring x (result - reference), and ring x reference.
AmplitudeSums scale_sums(const PairSamples& samples,
                         const Rectangle& block,
                         const std::vector<float>& result,
                         const std::vector<float>& reference) {
  AmplitudeSums sums;
  for (int y = std::max(block.y0, 1); y < std::min(block.y1, samples.height - 1); ++y)
    for (int x = std::max(block.x0, 1); x < std::min(block.x1, samples.width - 1); ++x) {
      const auto pixel = samples.pixel_at(x, y);
      if (samples.included[pixel] == 0) continue;
      double ring = 0;
      for (int v = y - 1; v <= y + 1; ++v)
        for (int u = x - 1; u <= x + 1; ++u)
          if (u != x || v != y) ring += luminance_of(reference, samples.pixel_at(u, v)) / 8;
      const double own = luminance_of(reference, pixel);
      sums.product += ring * (luminance_of(result, pixel) - own);
      sums.norm += ring * own;
    }
  return sums;
}

std::optional<StokesScale> scale_of(const PairSamples& samples,
                                    const std::vector<float>& result,
                                    const std::vector<float>& reference) {
  constexpr double kFirmness = 4;  // the reference's sum over its scatter from block to block
  const double false_alarms = 1e-4 / 3 / samples.looks;
  std::vector<AmplitudeSums> blocks;
  double norm_squares = 0;
  for (const Rectangle& block : blocks_of(samples)) {
    blocks.push_back(scale_sums(samples, block, result, reference));
    norm_squares += blocks.back().norm * blocks.back().norm;
  }
  const auto off = amplitude_of(blocks);
  if (!(off.norm > kFirmness * std::sqrt(norm_squares))) return std::nullopt;
  const double size = std::fabs(off.value());
  StokesScale scale{.ratio = 1 + off.value()};
  if (size > off.reach(off.of_noise, false_alarms))
    scale.certain = std::max(0.0, size - off.reach(off.of_remainder, false_alarms));
  return scale;
}

}  // namespace

std::optional<double> stokes_error(const PairSamples& samples) {
  if (!samples.result_stokes || !samples.reference_stokes) return std::nullopt;
  double light = 0;
  for (std::size_t pixel = 0; pixel < samples.pixel_count(); ++pixel)
    if (samples.included[pixel] != 0) light += luminance_of(samples.reference, pixel);
  if (!(light > 0)) return std::nullopt;
  const auto& result = *samples.result_stokes;
  const auto& reference = *samples.reference_stokes;
  double squares = 0;
  for (std::size_t i = 0; i < result.size(); ++i)
    squares +=
        mean_square_of_blocks(samples, result.at(i), reference.at(i)) / static_cast<double>(result.size());
  return std::sqrt(squares) / (light / static_cast<double>(samples.included_count));
}

std::optional<StokesScale> stokes_scale(const PairSamples& samples) {
  if (!samples.result_stokes || !samples.reference_stokes) return std::nullopt;
  std::optional<StokesScale> worst;
  for (std::size_t i = 0; i < samples.reference_stokes->size(); ++i) {
    auto scale = scale_of(samples, samples.result_stokes->at(i), samples.reference_stokes->at(i));
    if (!scale || (worst && scale->certain <= worst->certain)) continue;
    scale->parameter = static_cast<int>(i) + 1;
    worst = scale;
  }
  return worst;
}

MetricResult compute_stokes_error(const ImagePair& pair) {
  MetricResult result{stokes_error(pair)};
  if (!pair.reference_stokes)
    result.absence = Absence::NothingInReference;
  else if (!pair.result_stokes)
    result.absence = Absence::MissingInResult;
  return result;
}

MetricResult compute_stokes_scale_error(const ImagePair& pair) {
  const auto scale = stokes_scale(pair);
  if (!scale) return {.value = std::nullopt, .absence = Absence::NothingInReference};
  return {.value = scale->certain,
          .what = fmt::format("S{} is {:.3g} times what it should be", scale->parameter, scale->ratio)};
}

std::string describe_stokes_scale_error(const Measurement& measurement, const Limits& limits) {
  if (!measurement.value) return "no Stokes parameter of the reference stands out from its noise";
  constexpr double kPercent = 100;
  return fmt::format("{}, {:.3g} % off or more for certain, {}", measurement.what,
                     kPercent * *measurement.value, limits_text(limits, kPercent, " %"));
}

std::string describe_stokes_error(const Measurement& measurement, const Limits& limits) {
  if (!measurement.value && measurement.absence == Absence::NothingInReference)
    return "the reference has no Stokes parameters to be compared with";
  if (!measurement.value && measurement.absence == Absence::MissingInResult)
    return "it has no Stokes parameters (layers S1, S2 and S3), which the scene asks for";
  if (!measurement.value) return "stokes_error has no value for this image: the reference is black";
  constexpr double kPercent = 100;
  return fmt::format("its Stokes parameters are off by {:.3g} % of the light, {}",
                     kPercent * *measurement.value, limits_text(limits, kPercent, " %"));
}

}  // namespace orbs::metrics
