#include "metrics/stokes_scale.h"

#include "base/statistics.h"
#include "image/colour.h"
#include "metrics/describe.h"
#include "metrics/stokes.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <fmt/format.h>

namespace orbs::metrics {

namespace stokes_scale {

namespace {

using Complex = std::complex<double>;

constexpr double kHalfTurn_deg = 90;  // which brings linear polarisation to itself, taken to both sides
constexpr double kDegreesOfTurn = 90 / std::numbers::pi;  // S1 + i S2 turns by twice the angle

// Of one block: sums of ring[i] x parameter[j]. For S3 with itself alone, (2, 2).
struct BlockSums {
  std::array<std::array<double, 3>, 3> result{};
  std::array<std::array<double, 3>, 3> reference{};
  std::array<double, 3> ring{};
};

struct Sums {
  std::vector<BlockSums> blocks;
  BlockSums total;
  double light = 0;  // mean luminance
};

double ring_of(const PairSamples& samples, const std::vector<double>& reference, int x, int y) {
  double ring = 0;
  for (int v = y - 1; v <= y + 1; ++v)
    for (int u = x - 1; u <= x + 1; ++u)
      if (u != x || v != y) ring += reference[samples.pixel_at(u, v)] / 8;
  return ring;
}

using Luminances = std::array<std::vector<double>, 3>;

Luminances luminances_of(const StokesSamples& stokes, std::size_t pixels) {
  Luminances out;
  for (std::size_t i = 0; i < out.size(); ++i)
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
      out.at(i).push_back(luminance_at(stokes.at(i), pixel));
  return out;
}

void add(const BlockSums& from, BlockSums& to) {
  for (std::size_t i = 0; i < 3; ++i) {
    to.ring.at(i) += from.ring.at(i);
    for (std::size_t j = 0; j < 3; ++j) {
      to.result.at(i).at(j) += from.result.at(i).at(j);
      to.reference.at(i).at(j) += from.reference.at(i).at(j);
    }
  }
}

// Smaller in small images: noise that is read off a few blocks is hardly known.
int block_side_of(const PairSamples& samples) {
  constexpr int kFew = 48;
  int side = kBlock_px;
  while (side > 2 && (samples.width / side) * (samples.height / side) < kFew) side /= 2;
  return side;
}

void add_pixel(const PairSamples& samples,
               const Luminances& result,
               const Luminances& reference,
               std::array<int, 2> at,
               BlockSums& sums) {
  const auto [x, y] = at;
  const auto pixel = samples.pixel_at(x, y);
  if (samples.included[pixel] == 0) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const double ring = ring_of(samples, reference.at(i), x, y);
    sums.ring.at(i) += ring;
    for (std::size_t j = 0; j < 3; ++j) {
      sums.result.at(i).at(j) += ring * result.at(j)[pixel];
      sums.reference.at(i).at(j) += ring * reference.at(j)[pixel];
    }
  }
}

Sums sums_of(const PairSamples& samples) {
  const auto result = luminances_of(*samples.result_stokes, samples.pixel_count());
  const auto reference = luminances_of(*samples.reference_stokes, samples.pixel_count());
  const auto sums_of_block = [&](int x0, int y0, int side) {
    BlockSums sums;
    for (int y = y0; y < std::min(y0 + side, samples.height - 1); ++y)
      for (int x = x0; x < std::min(x0 + side, samples.width - 1); ++x)
        add_pixel(samples, result, reference, {x, y}, sums);
    return sums;
  };
  Sums all;
  const int side = block_side_of(samples);
  for (int y = 1; y < samples.height - 1; y += side)
    for (int x = 1; x < samples.width - 1; x += side) {
      all.blocks.push_back(sums_of_block(x, y, side));
      add(all.blocks.back(), all.total);
    }
  for (std::size_t pixel = 0; pixel < samples.pixel_count(); ++pixel)
    if (samples.included[pixel] != 0) all.light += luminance_at(samples.reference, pixel);
  all.light /= static_cast<double>(samples.included_count);
  return all;
}

// The reference's sum is far above its scatter from block to block.
bool stands_out(const Sums& sums, std::size_t i) {
  constexpr double kFirmness = 4;
  double squares = 0;
  for (const auto& block : sums.blocks) squares += block.reference.at(i).at(i) * block.reference.at(i).at(i);
  return sums.total.reference.at(i).at(i) > kFirmness * std::sqrt(squares);
}

// Of the noise of both; that of the Stokes parameters is taken to be shared as that of the colours is.
double reference_share_of(const PairSamples& samples) {
  const double ratio =
      (samples.variance_ratio[0] + samples.variance_ratio[1] + samples.variance_ratio[2]) / 3;
  return ratio > 0 ? 1 / (1 + ratio) : 0;
}

// S1 to S3 are at most S0, path by path, and so are the noise that all pixels share and the light that no
// sample has found.
double common_reach_of(const PairSamples& samples, double light) {
  const auto& error = samples.common_noise.error;
  return std::max(kErrorsToPass * image::luminance(error[0], error[1], error[2]),
                  samples.unseen_share * light);
}

Complex linear(const std::array<std::array<double, 3>, 3>& sums) {
  return {sums[0][0] + sums[1][1], sums[0][1] - sums[1][0]};
}

StokesNumber turn_of(const PairSamples& samples, const Sums& sums) {
  const auto reference = linear(sums.total.reference);
  const auto ratio = linear(sums.total.result) / reference;
  if (!(std::abs(ratio) > 0)) return {.standard_error = kHalfTurn_deg};  // nothing is left of it
  const auto back = std::conj(ratio) / std::abs(ratio);
  PooledVariance left;
  for (const auto& block : sums.blocks) {
    const auto rest = (linear(block.result) - ratio * linear(block.reference)) / reference;
    const double across = (rest * back).imag();
    left.add(across * across);
  }
  const double rings = std::hypot(sums.total.ring[0], sums.total.ring[1]);
  const double per = kDegreesOfTurn / std::abs(ratio);
  return {kDegreesOfTurn * std::arg(ratio), per * std::sqrt(left.sum), left.degrees(),
          per * common_reach_of(samples, sums.light) * rings / std::abs(reference),
          reference_share_of(samples)};
}

// `turned`: by which S1 + i S2 of the result is multiplied first.
StokesNumber scale_of(const PairSamples& samples, const Sums& sums, std::size_t i, Complex turned) {
  const auto product = [&](const BlockSums& block) {
    const auto& row = block.result.at(i);
    if (i == 0) return turned.real() * row[0] - turned.imag() * row[1];
    if (i == 1) return turned.imag() * row[0] + turned.real() * row[1];
    return row[2];
  };
  const double norm = sums.total.reference.at(i).at(i);
  const double scale = product(sums.total) / norm;
  PooledVariance left;
  for (const auto& block : sums.blocks) {
    const double rest = (product(block) - scale * block.reference.at(i).at(i)) / norm;
    left.add(rest * rest);
  }
  return {scale, std::sqrt(left.sum), left.degrees(),
          common_reach_of(samples, sums.light) * std::fabs(sums.total.ring.at(i)) / norm,
          reference_share_of(samples)};
}

Interval within(const StokesNumber& number, double one_side, int looks) {
  auto interval = student_interval(number.value, number.standard_error, number.degrees, 2 * one_side / looks);
  interval.low = std::min(interval.low, interval.value - number.in_common);
  interval.high = std::max(interval.high, interval.value + number.in_common);
  return interval;
}

Complex undone(const StokesNumber& turn_deg, int looks) {
  constexpr double kMost_deg = 22.5;
  const auto interval = within(turn_deg, kWrongFails, looks);
  const bool is_certain = interval.low > 0 || interval.high < 0;
  if (!is_certain || std::fabs(turn_deg.value) > kMost_deg) return {1, 0};
  return std::polar(1.0, -turn_deg.value / kDegreesOfTurn);
}

MetricResult measured(const StokesNumber& number, double zero, int looks) {
  const auto to_fail = within(number, kWrongFails, looks);
  MetricResult result{number.value - zero};
  result.low = to_fail.low - zero;
  result.high = to_fail.high - zero;
  if (looks == 1) return result;
  const auto to_pass = within(number, kWrongPasses, looks);
  result.to_pass = ToPass{to_pass.low - zero, to_pass.high - zero, number.reference_share};
  return result;
}

MetricResult absent(const PairSamples& samples) {
  if (samples.reference_stokes && !samples.result_stokes)
    return {.value = std::nullopt,
            .absence = Absence::MissingInResult,
            .what = "it has no Stokes parameters (layers S1, S2 and S3), which the scene asks for"};
  return {.value = std::nullopt,
          .absence = Absence::NothingInReference,
          .what = "the reference has no Stokes parameters to be compared with"};
}

}  // namespace

}  // namespace stokes_scale

std::optional<StokesScales> stokes_scales(const PairSamples& samples) {
  if (!samples.result_stokes || !samples.reference_stokes) return std::nullopt;
  const auto sums = stokes_scale::sums_of(samples);
  if (!(sums.light > 0)) return std::nullopt;
  StokesScales out;
  std::array<bool, 3> is_judged{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double square = sums.total.reference.at(i).at(i) / static_cast<double>(samples.included_count);
    out.share.at(i) = std::sqrt(std::max(0.0, square)) / sums.light;
    is_judged.at(i) = out.share.at(i) >= kLeastShare && stokes_scale::stands_out(sums, i);
  }
  stokes_scale::Complex turned{1, 0};
  if (is_judged[0] || is_judged[1]) {
    out.turn_deg = stokes_scale::turn_of(samples, sums);
    turned = stokes_scale::undone(*out.turn_deg, samples.looks);
  }
  for (std::size_t i = 0; i < 3; ++i)
    if (is_judged.at(i)) out.scale.at(i) = stokes_scale::scale_of(samples, sums, i, turned);
  return out;
}

namespace stokes_scale {

MetricResult compute(const ImagePair& pair, std::size_t parameter) {
  const auto scales = stokes_scales(pair);
  const auto name = fmt::format("S{}", parameter + 1);
  if (!scales) return absent(pair);
  if (const auto& scale = scales->scale.at(parameter)) {
    auto result = measured(*scale, 1, pair.looks);
    result.what = name;
    return result;
  }
  return {.value = std::nullopt,
          .absence = Absence::NothingInReference,
          .what = fmt::format("{} of the reference is {:.2g} % of the light, too little to judge its "
                              "scale and sign",
                              name, 100 * scales->share.at(parameter))};
}

std::string describe(const Measurement& measurement, const Limits& limits) {
  constexpr double kPercent = 100;
  if (!measurement.value) return measurement.what;
  const double value = *measurement.value;
  const double low = measurement.low.value_or(value);
  const double high = measurement.high.value_or(value);
  const auto allowed = limits_text(limits, kPercent, " %");
  constexpr double kLost = 0.2;  // of the parameter
  if (1 + low > -kLost && 1 + low <= 0 && 1 + high >= 0 && 1 + high < kLost)
    return fmt::format("{} is missing ({:.2g} to {:.2g} times what it should be), {}", measurement.what,
                       1 + low, 1 + high, allowed);
  if (1 + high < 0)
    return fmt::format("{} has the other sign ({:.3g} to {:.3g} times what it should be), {}",
                       measurement.what, 1 + low, 1 + high, allowed);
  if (1 + low <= 0)
    return fmt::format(
        "{} is {:.2g} times what it should be ({:.2g} to {:.2g}), so that not even its sign is sure, {}",
        measurement.what, 1 + value, 1 + low, 1 + high, allowed);
  const double sign = value < 0 ? -1 : 1;
  return fmt::format("{} is {:.2g} % too {} ({:.2g} to {:.2g} %), {}", measurement.what,
                     kPercent * sign * value, value < 0 ? "small" : "large",
                     kPercent * std::min(sign * low, sign * high),
                     kPercent * std::max(sign * low, sign * high), allowed);
}

}  // namespace stokes_scale

MetricResult compute_stokes_turn(const ImagePair& pair) {
  const auto scales = stokes_scales(pair);
  if (!scales) return stokes_scale::absent(pair);
  if (!scales->turn_deg)
    return {.value = std::nullopt,
            .absence = Absence::NothingInReference,
            .what = "the reference has too little linear polarisation to judge its frame"};
  return stokes_scale::measured(*scales->turn_deg, 0, pair.looks);
}

std::string describe_stokes_turn(const Measurement& measurement, const Limits& limits) {
  if (!measurement.value) return measurement.what;
  if (measurement.high.value_or(0) - *measurement.value >= stokes_scale::kHalfTurn_deg / 2)
    return "the turn of its frame is lost in noise, or nothing is left of S1 and S2";
  const double sign = *measurement.value < 0 ? -1 : 1;
  const double low = sign * measurement.low.value_or(*measurement.value);
  const double high = sign * measurement.high.value_or(*measurement.value);
  return fmt::format("its frame is turned by {:.2g} degrees ({:.2g} to {:.2g}), {}",
                     sign * *measurement.value, std::min(low, high), std::max(low, high),
                     limits_text(limits));
}

}  // namespace orbs::metrics
