#include "metrics/coverage_edges.h"

#include "base/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbs::metrics {

namespace {

// By the steps to the next pixels to the right and below.
double edge_length_at(const PairSamples& samples, const std::vector<float>& coverage, std::size_t pixel) {
  const int x = static_cast<int>(pixel) % samples.width;
  const int y = static_cast<int>(pixel) / samples.width;
  const auto step_to = [&](bool is_there, std::size_t other) {
    if (!is_there || samples.included[other] == 0) return 0.0;
    return static_cast<double>(coverage[other]) - static_cast<double>(coverage[pixel]);
  };
  return std::hypot(step_to(x + 1 < samples.width, pixel + 1),
                    step_to(y + 1 < samples.height, pixel + static_cast<std::size_t>(samples.width)));
}

struct EdgeSums {
  double squares = 0;   // of the differences
  double one = 0;       // c (1 - c)
  double length = 0;    // of the edges, in px
  double variance = 0;  // of `squares`, by n samples a pixel
};

// The square of a binomial mean about its expectation: of p (1 - p) / n the variance is twice the square and
// p (1 - p) (1 - 6 p (1 - p)) / n^3.
EdgeSums sums_of(const PairSamples& samples, const LayerChannel& coverage, double n) {
  EdgeSums sums;
  for (std::size_t i = 0; i < samples.pixel_count(); ++i) {
    if (samples.included[i] == 0) continue;
    const double covered = static_cast<double>(coverage.reference[i]);
    const double off = static_cast<double>(coverage.result[i]) - covered;
    const double one = covered * (1 - covered);
    sums.squares += off * off;
    sums.one += one;
    sums.length += edge_length_at(samples, coverage.reference, i);
    sums.variance += 2 * one * one / (n * n) + one * std::max(0.0, 1 - 6 * one) / (n * n * n);
  }
  return sums;
}

double samples_of_a_render(const PairSamples& samples) {
  constexpr double kOfFirstLook = 8;
  if (samples.spp <= 0) return kOfFirstLook;
  return std::clamp(samples.spp / 2.0, 1.0, kOfFirstLook);
}

}  // namespace

CoverageEdges coverage_edges(const PairSamples& samples, const LayerChannel& coverage, double false_alarms) {
  constexpr double kAllowed = 0.25;
  constexpr double kOfEdge = 1.0 / 6;
  constexpr double kNormal = 1e9;  // degrees of freedom
  const double n = samples_of_a_render(samples);
  const auto sums = sums_of(samples, coverage, n);
  if (!std::isfinite(sums.squares))
    return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const double unit = std::max(sums.one, kOfEdge * sums.length);
  if (!(unit > 0)) return {};  // no edges: layer_pixels judges what is all covered or bare
  const double by_noise = sums.one / n + student_quantile(false_alarms, kNormal) * std::sqrt(sums.variance);
  const double error = sums.squares / unit;
  return {error, std::max(0.0, error - std::max(kAllowed, by_noise / unit))};
}

}  // namespace orbs::metrics
