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
using Neighbours = std::array<std::size_t, 9>;  // pixels

Neighbours neighbours_of(const PairSamples& samples, int x, int y) {
  Neighbours all{};
  std::size_t next = 0;
  for (int v = y - 1; v <= y + 1; ++v)
    for (int u = x - 1; u <= x + 1; ++u)
      all.at(next++) =
          static_cast<std::size_t>(v) * static_cast<std::size_t>(samples.width) + static_cast<std::size_t>(u);
  return all;
}

double filtered(const std::vector<float>& image, const Neighbours& around, std::size_t channel) {
  double sum = 0;
  for (std::size_t i = 0; i < around.size(); ++i)
    sum += kFilter.at(i) * static_cast<double>(image[3 * around.at(i) + channel]);
  return sum;
}

// Of filtered reference - reference, as the noise of pixels is independent.
double change_variance(const PairSamples& samples, const Neighbours& around, std::size_t channel) {
  double sum = 0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const double weight = kFilter.at(i) - (i == kMiddle ? 1 : 0);
    sum += weight * weight * variance_at(samples.reference_variance, 3 * around.at(i) + channel);
  }
  return sum;
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
  double change = 0;  // |change|
  double error = 0;   // in the direction of the change
};

Edge edge_at(const PairSamples& samples, const Neighbours& around, const std::array<double, 3>& means) {
  constexpr double kEdge = 0.05;
  constexpr double kStandardDeviations = 5;
  Edge edge;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!(means.at(c) > 0)) continue;
    const std::size_t here = 3 * around[kMiddle] + c;
    const double soft = filtered(samples.reference, around, c);
    // Below 0 only in a difference of images.
    const double scale = std::max(0.0, soft) + means.at(c);
    const double change = (soft - static_cast<double>(samples.reference[here])) / scale;
    // In this order, as most pixels lie at no edge and their noise need not be known.
    if (std::fabs(change) <= kEdge) continue;
    const double deviation = std::sqrt(change_variance(samples, around, c)) / scale;
    if (std::fabs(change) <= kStandardDeviations * deviation) continue;
    edge.change += std::fabs(change);
    edge.error += std::copysign(1.0, change) * samples.difference(here) / scale;
  }
  return edge;
}

std::vector<Edge> edges_of(const PairSamples& samples) {
  const auto means = reference_means(samples);
  std::vector<Edge> edges;
  for (int y = 1; y + 1 < samples.height; ++y)
    for (int x = 1; x + 1 < samples.width; ++x) {
      const auto around = neighbours_of(samples, x, y);
      if (std::any_of(around.begin(), around.end(), [&](auto i) { return samples.included[i] == 0; }))
        continue;
      const auto edge = edge_at(samples, around, means);
      if (edge.change > 0) edges.push_back(edge);
    }
  return edges;
}

}  // namespace

std::optional<EdgeBlur> edge_blur(const PairSamples& samples) {
  constexpr std::size_t kFewestPixels = 100;
  const auto edges = edges_of(samples);
  if (edges.size() < kFewestPixels) return std::nullopt;
  Edge sum;
  for (const auto& [change, error] : edges) {
    sum.change += change;
    sum.error += error;
  }
  const double value = sum.error / sum.change;
  double scatter = 0;
  for (const auto& [change, error] : edges) {
    const double rest = error - value * change;
    scatter += rest * rest;
  }
  return EdgeBlur{value, std::sqrt(scatter) / sum.change};
}

MetricResult compute_edge_blur(const ImagePair& pair) {
  constexpr double kStandardErrors = 3;
  const auto blur = edge_blur(pair);
  if (!blur) return {.value = std::nullopt, .absence = Absence::NothingInReference};
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
