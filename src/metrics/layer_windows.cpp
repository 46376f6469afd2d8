#include "metrics/layer_windows.h"

#include "base/statistics.h"
#include "metrics/layer_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <fmt/format.h>

namespace orbs::metrics {

namespace {

constexpr int kLeastWindow_px = 8;

// A quantity of a layer in one pixel, relative to the largest vector that the pixel shows.
struct Point {
  double off = 0;        // of the result from the reference
  double range = 0;      // that the pixel shows
  double from_mean = 0;  // the most by which the pixel's middle differs from its mean
  double weight = 0;     // 1 / variance of one sample at most; 0: the pixel does not count
};

// By pixels.
struct Quantity {
  std::string name;
  std::vector<Point> points;
};

bool counts(const PairSamples& samples, std::size_t pixel) {
  return samples.included[pixel] != 0 && samples.layers->coverage[pixel] >= 1;
}

double length_of(const ComparedLayer& layer, std::size_t pixel) {
  double squares = 0;
  for (const auto& channel : layer.channels) {
    const double most = std::max(std::fabs(static_cast<double>(channel.least[pixel])),
                                 std::fabs(static_cast<double>(channel.most[pixel])));
    squares += most * most;
  }
  return std::sqrt(squares);
}

// The difference beyond the rounding of single precision; what is no number stays none.
double beyond_rounding(double off, double rounding) {
  if (!std::isfinite(off)) return off;
  return std::copysign(std::max(0.0, std::fabs(off) - rounding), off);
}

// |a(i - 1) - 2 a(i) + a(i + 1)| along an axis; nothing at the end of the image or of what is covered.
std::optional<double> second_difference(const PairSamples& samples,
                                        const std::vector<float>& values,
                                        std::size_t pixel,
                                        std::size_t step,
                                        bool has_both) {
  if (!has_both || samples.layers->coverage[pixel - step] < 1 || samples.layers->coverage[pixel + step] < 1)
    return std::nullopt;
  return std::fabs(static_cast<double>(values[pixel - step]) - 2 * static_cast<double>(values[pixel]) +
                   static_cast<double>(values[pixel + step]));
}

// A parabola a x^2 over a pixel has the mean a / 12 beyond its middle and the second difference 2 a. Its
// range is a / 4 at least, which tells where neighbours do not.
double from_mean(const PairSamples& samples, const LayerChannel& channel, std::size_t pixel) {
  constexpr double kOfSecondDifference = 1.0 / 24;
  constexpr double kOfRange = 1.0 / 3;
  const int x = static_cast<int>(pixel) % samples.width;
  const int y = static_cast<int>(pixel) / samples.width;
  const auto along_x =
      second_difference(samples, channel.reference, pixel, 1, x > 0 && x < samples.width - 1);
  const auto along_y =
      second_difference(samples, channel.reference, pixel, static_cast<std::size_t>(samples.width),
                        y > 0 && y < samples.height - 1);
  if (along_x && along_y) return kOfSecondDifference * (*along_x + *along_y);
  return kOfRange * (static_cast<double>(channel.most[pixel]) - static_cast<double>(channel.least[pixel]));
}

// What the pixel shows, the result's value included where that is what a neighbour shows: of a thing with the
// smallest share of the pixel the result may have met what no sample of the reference has.
double range_of(const PairSamples& samples, const LayerChannel& channel, std::size_t pixel) {
  const double value = static_cast<double>(channel.result[pixel]);
  double least = static_cast<double>(channel.least[pixel]);
  double most = static_cast<double>(channel.most[pixel]);
  if (value >= least && value <= most) return most - least;
  const auto beside = range_beside(samples, channel, pixel);
  if (value < least) least = std::max(value, beside.least);
  if (value > most) most = std::min(value, beside.most);
  return most - least;
}

Point point_of(const PairSamples& samples, const LayerChannel& channel, std::size_t pixel, double rounding) {
  const double off =
      static_cast<double>(channel.result[pixel]) - static_cast<double>(channel.reference[pixel]);
  return {.off = beyond_rounding(off, rounding),
          .range = range_of(samples, channel, pixel),
          .from_mean = from_mean(samples, channel, pixel),
          .weight = 1};
}

void divide(Point& point, double by) {
  point.off /= by;
  point.range /= by;
  point.from_mean /= by;
}

// Where half of the range is less than half a step of a half float, that is what tells pixels apart no more.
void weigh(Point& point) {
  const double noise = point.range / 2;
  const double rounding = kHalfStep / 2;
  point.weight = 1 / (noise * noise + rounding * rounding);
}

Quantity along_channel(const PairSamples& samples,
                       const ComparedLayer& layer,
                       std::size_t c,
                       double rounding) {
  Quantity quantity{layer.channels[c].name, std::vector<Point>(samples.pixel_count())};
  for (std::size_t i = 0; i < samples.pixel_count(); ++i) {
    const double length = length_of(layer, i);
    if (!counts(samples, i) || !(length > 0)) continue;
    auto& point = quantity.points[i] = point_of(samples, layer.channels[c], i, rounding);
    divide(point, length);
    weigh(point);
  }
  return quantity;
}

// The sum of the channels' errors, each times the part that it has of the vector.
Quantity along_itself(const PairSamples& samples, const ComparedLayer& layer, double rounding) {
  Quantity quantity{fmt::format("the length of {}", layer.layer->name),
                    std::vector<Point>(samples.pixel_count())};
  for (std::size_t i = 0; i < samples.pixel_count(); ++i) {
    const double length = length_of(layer, i);
    if (!counts(samples, i) || !(length > 0)) continue;
    auto& point = quantity.points[i];
    for (const auto& channel : layer.channels) {
      const auto of_channel = point_of(samples, channel, i, rounding);
      const double part = static_cast<double>(channel.reference[i]) / length;
      point.off += part * of_channel.off;
      point.range += std::fabs(part) * of_channel.range;
      point.from_mean += std::fabs(part) * of_channel.from_mean;
    }
    divide(point, length);
    weigh(point);
  }
  return quantity;
}

std::vector<Quantity> quantities_of(const PairSamples& samples, const ComparedLayer& layer) {
  const double rounding = kLayerRounding * layer_size(samples, layer);
  std::vector<Quantity> quantities;
  for (std::size_t c = 0; c < layer.channels.size(); ++c)
    quantities.push_back(along_channel(samples, layer, c, rounding));
  if (layer.channels.size() > 1) quantities.push_back(along_itself(samples, layer, rounding));
  return quantities;
}

std::vector<Rectangle> windows_of(const PairSamples& samples) {
  std::vector<Rectangle> windows;
  for (int side = kLeastWindow_px;; side *= 2) {
    for (int y = 0; y < samples.height; y += side)
      for (int x = 0; x < samples.width; x += side)
        windows.push_back({x, y, std::min(x + side, samples.width), std::min(y + side, samples.height)});
    if (side >= std::max(samples.width, samples.height)) return windows;
  }
}

// Sums over the pixels of a window.
struct WindowSums {
  double weight = 0;
  double off = 0;    // weighted
  double noise = 0;  // of the weighted sum: its variance at most
  double place = 0;  // what the place of the samples may make of the weighted sum
  int pixels = 0;
};

WindowSums sums_of(const PairSamples& samples, const Quantity& quantity, const Rectangle& window) {
  constexpr double kPlace_px = 1.0 / 16;
  WindowSums sums;
  for_each_block_pixel(samples, window, [&](std::size_t i) {
    const auto& point = quantity.points[i];
    if (point.weight == 0) return;
    sums.weight += point.weight;
    sums.off += point.weight * point.off;
    sums.noise += point.weight * point.weight * point.range * point.range / 4;
    sums.place += point.weight * (kPlace_px * point.range + point.from_mean);
    ++sums.pixels;
  });
  return sums;
}

// Of the weighted sum, by its pixels' scatter about the mean, and by what no sample may have met: of a thing
// that fills a small share of its pixels the samples see nothing, and do not scatter. It was to be expected t
// / h times if the sum lacks t, and one hit brings h, the whole range of a pixel; by Poisson there is none
// with the probability exp(-t / h).
double scatter_reach(const PairSamples& samples,
                     const Quantity& quantity,
                     const Rectangle& window,
                     const WindowSums& sums,
                     double false_alarms) {
  PooledVariance scatter;
  double hit = 0;
  for_each_block_pixel(samples, window, [&](std::size_t i) {
    const auto& point = quantity.points[i];
    hit = std::max(hit, point.weight * point.range);
    const double step = point.weight * (point.off - sums.off / sums.weight);
    if (point.weight > 0) scatter.add(step * step);
  });
  const double degrees = scatter.degrees() - 1;  // one for the mean
  if (!(degrees >= 1)) return std::numeric_limits<double>::infinity();
  const double unbiased = static_cast<double>(sums.pixels) / (sums.pixels - 1);
  return student_quantile(false_alarms, degrees) * std::sqrt(unbiased * scatter.sum) -
         hit * std::log(false_alarms);
}

// Nothing where no pixel counts.
std::optional<LayerWindow> window_error(const PairSamples& samples,
                                        const Quantity& quantity,
                                        const Rectangle& window,
                                        double false_alarms,
                                        double normal_quantile) {
  const auto sums = sums_of(samples, quantity, window);
  if (sums.pixels == 0) return std::nullopt;
  const double off = std::fabs(sums.off) / sums.weight;
  const auto text = fmt::format("the mean of {} over {} x {} px is off by {:.3g} %", quantity.name,
                                window.x1 - window.x0, window.y1 - window.y0, 100 * off);
  if (!std::isfinite(off)) return LayerWindow{window, text, std::numeric_limits<double>::infinity()};
  const double bound = normal_quantile * std::sqrt(sums.noise);
  const double left = std::fabs(sums.off) - sums.place;
  if (!(left > 0)) return LayerWindow{window, text, 0};
  // Student's quantiles take time, and are needed only where the bound hides something.
  const double noise =
      bound > 0 ? std::min(bound, scatter_reach(samples, quantity, window, sums, false_alarms)) : 0;
  return LayerWindow{window, text, std::max(0.0, left - noise) / sums.weight};
}

}  // namespace

double window_tests(const PairSamples& samples, const ComparedLayer& layer) {
  const std::size_t quantities = layer.channels.size() + (layer.channels.size() > 1 ? 1 : 0);
  return static_cast<double>(quantities * windows_of(samples).size());
}

LayerWindow worst_window(const PairSamples& samples, const ComparedLayer& layer, double false_alarms) {
  constexpr double kNormal = 1e9;  // degrees of freedom
  const double normal_quantile = student_quantile(false_alarms, kNormal);
  const auto windows = windows_of(samples);
  LayerWindow worst;
  for (const auto& quantity : quantities_of(samples, layer))
    for (const auto& window : windows) {
      auto error = window_error(samples, quantity, window, false_alarms, normal_quantile);
      if (error && error->certain > worst.certain) worst = std::move(*error);
    }
  return worst;
}

}  // namespace orbs::metrics
