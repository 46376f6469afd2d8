#include "metrics/edge_blur.h"

#include "metrics/describe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace orbs::metrics {

namespace {

// A pixel and its neighbours, by rows, and the filter [1 2 1] / 4 in x and y.
constexpr std::size_t kMiddle = 4;
constexpr std::array<double, 9> kFilter{1 / 16.0, 2 / 16.0, 1 / 16.0, 2 / 16.0, 4 / 16.0,
                                        2 / 16.0, 1 / 16.0, 2 / 16.0, 1 / 16.0};
// The samples of the reference's row y, filtered; those of its first and last pixel are left as they are.
void filter_row(const PairSamples& samples, int y, std::vector<double>& filtered) {
  const auto row_length = 3 * static_cast<std::size_t>(samples.width);
  const float* const above = &samples.reference[static_cast<std::size_t>(y - 1) * row_length];
  filtered.resize(row_length);
  for (std::size_t i = 3; i + 3 < row_length; ++i) {
    double sum = 0;
    for (std::size_t v = 0; v < 3; ++v)
      for (std::size_t u = 0; u < 3; ++u)
        sum += kFilter[3 * v + u] * static_cast<double>(above[v * row_length + i + 3 * u - 3]);
    filtered[i] = sum;
  }
}

// Visits (pixel, place in the filter) of the pixel and its neighbours.
template <typename Visit>
void for_each_around(const PairSamples& samples, std::size_t pixel, Visit visit) {
  const auto width = static_cast<std::size_t>(samples.width);
  for (std::size_t i = 0; i < kFilter.size(); ++i) visit(pixel + (i / 3) * width + i % 3 - width - 1, i);
}

// Of filtered reference - reference, as the noise of pixels is independent.
double change_variance(const PairSamples& samples, std::size_t pixel, std::size_t channel) {
  double sum = 0;
  for_each_around(samples, pixel, [&](std::size_t at, std::size_t place) {
    const double weight = kFilter.at(place) - (place == kMiddle ? 1 : 0);
    sum += weight * weight * variance_at(samples.reference_variance, 3 * at + channel);
  });
  return sum;
}

bool is_counted_around(const PairSamples& samples, std::size_t pixel) {
  bool is_counted = true;
  for_each_around(samples, pixel,
                  [&](std::size_t at, std::size_t) { is_counted = is_counted && samples.included[at] != 0; });
  return is_counted;
}

std::array<double, 3> reference_means(const PairSamples& samples) {
  std::array<double, 3> means{};
  double count = 0;
  for (std::size_t pixel = 0; pixel < samples.included.size(); ++pixel) {
    if (samples.included[pixel] == 0) continue;
    count += 1;
    for (std::size_t c = 0; c < 3; ++c) means.at(c) += static_cast<double>(samples.reference[3 * pixel + c]);
  }
  for (double& mean : means) mean /= count;
  return means;
}

// Change: what the filter makes of the reference. Summed over the channels of a pixel, whose noise is not
// independent.
struct Edge {
  double change = 0;         // |change|
  double error = 0;          // in the direction of the change
  double counted_noise = 0;  // standard deviations of the error, see EdgeBlur
  double seen_noise = 0;
};

// `filtered`: the pixel's three samples.
Edge edge_at(const PairSamples& samples,
             std::size_t pixel,
             const double* filtered,
             const std::array<double, 3>& means) {
  constexpr double kEdge = 0.05;
  constexpr double kStandardDeviations = 5;
  Edge edge;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!(means.at(c) > 0)) continue;
    const std::size_t here = 3 * pixel + c;
    const double soft = filtered[c];
    // Below 0 only in a difference of images.
    const double scale = std::max(0.0, soft) + means.at(c);
    const double change = (soft - static_cast<double>(samples.reference[here])) / scale;
    // In this order, as most pixels lie at no edge and their noise need not be known.
    if (std::fabs(change) <= kEdge) continue;
    const double deviation = std::sqrt(change_variance(samples, pixel, c)) / scale;
    if (std::fabs(change) <= kStandardDeviations * deviation) continue;
    edge.change += std::fabs(change);
    edge.error += std::copysign(1.0, change) * samples.difference(here) / scale;
    if (samples.looks == 1) continue;
    const double reference = std::sqrt(variance_at(samples.reference_variance, here)) / scale;
    edge.counted_noise += std::sqrt(samples.variance_ratio.at(c) + 1) * reference;
    edge.seen_noise += std::sqrt(samples.seen_variance_ratio.at(c) + 1) * reference;
  }
  return edge;
}

std::vector<Edge> edges_of(const PairSamples& samples) {
  const auto means = reference_means(samples);
  std::vector<Edge> edges;
  std::vector<double> filtered;
  for (int y = 1; y + 1 < samples.height; ++y) {
    filter_row(samples, y, filtered);
    for (int x = 1; x + 1 < samples.width; ++x) {
      const auto pixel = samples.pixel_at(x, y);
      const auto edge = edge_at(samples, pixel, &filtered[3 * static_cast<std::size_t>(x)], means);
      if (edge.change > 0 && is_counted_around(samples, pixel)) edges.push_back(edge);
    }
  }
  return edges;
}

}  // namespace

std::optional<EdgeBlur> edge_blur(const PairSamples& samples) {
  constexpr std::size_t kFewestPixels = 100;
  const auto edges = edges_of(samples);
  if (edges.size() < kFewestPixels) return std::nullopt;
  Edge sum;
  for (const auto& edge : edges) {
    sum.change += edge.change;
    sum.error += edge.error;
  }
  const double value = sum.error / sum.change;
  PooledVariance scatter;
  double counted = 0;
  double seen = 0;
  for (const auto& edge : edges) {
    const double rest = edge.error - value * edge.change;
    scatter.add(rest * rest);
    counted += edge.counted_noise * edge.counted_noise;
    seen += edge.seen_noise * edge.seen_noise;
  }
  return EdgeBlur{value, std::sqrt(scatter.sum) / sum.change, scatter.degrees(),
                  std::sqrt(counted) / sum.change, std::sqrt(seen) / sum.change};
}

MetricResult compute_edge_blur(const ImagePair& pair) {
  constexpr double kStandardErrors = 3;
  const auto blur = edge_blur(pair);
  if (!blur) return {.value = std::nullopt, .absence = Absence::NothingInReference};
  if (pair.looks > 1) {
    // The few pixels at edges may have met no firefly that the whole image shows.
    const auto within = [&](double error, double one_side) {
      return student_interval(blur->value, std::max(blur->standard_error, error), blur->degrees,
                              2 * one_side / pair.looks);
    };
    const auto to_fail = within(blur->counted_error, kWrongFails);
    const auto to_pass = within(blur->seen_error, kWrongPasses);
    return {.value = blur->value,
            .low = to_fail.low,
            .high = to_fail.high,
            .to_pass = ToPass{to_pass.low, to_pass.high}};
  }
  const double reach = kStandardErrors * blur->standard_error;
  return {.value = blur->value, .low = blur->value - reach, .high = blur->value + reach};
}

std::string describe_edge_blur(const Measurement& measurement, const Limits& limits) {
  if (!measurement.value) return "the reference has no edges to be compared with";
  const double value = *measurement.value;
  const double low = measurement.low.value_or(value);
  const double high = measurement.high.value_or(value);
  constexpr std::string_view kText = "edges are {} by {:.3g} ({:.3g} to {:.3g}) of a 3 x 3 px filter, {}";
  if (value >= 0) return fmt::format(kText, "blurred", value, low, high, limits_text(limits));
  // How much sharper they are is told without a sign, so ends and limits change sides.
  Limits of_sharpness;
  if (limits.max) of_sharpness.min = -*limits.max;
  if (limits.min) of_sharpness.max = -*limits.min;
  return fmt::format(kText, "sharpened", -value, -high, -low, limits_text(of_sharpness));
}

}  // namespace orbs::metrics
