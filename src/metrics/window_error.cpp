#include "metrics/window_error.h"

#include "base/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace orbs::metrics {

namespace {

constexpr double kFalseAlarmsOfAllWindows = 1e-4;
constexpr double kEdge_px = 0.05;

// What is summed over a window; each is one number per pixel of one channel, 0 where the pixel does not
// count.
enum Summand {
  Count,
  Difference,
  Reference,
  Step,  // of the reference to its neighbours, in x and y together
  OwnVariance,
  OwnSquares,
  ExpectedVariance,
  ExpectedSquares,
  Pairs  // of the pixel and its right neighbour, in which the scatter is read
};
constexpr std::size_t kSummands = Pairs + 1;
using WindowSums = std::array<double, kSummands>;

// The sums of square cells by rows. A window is made of 8 x 8 of them: sums over its own cells alone, because
// a table of sums over the whole image loses the digits of what lies beyond a firefly.
struct Cells {
  int side_px = 1;
  int columns = 0;
  int rows = 0;
  std::vector<WindowSums> sums;

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  const WindowSums& at(int column, int row) const { return sums[index(column, row)]; }
};
constexpr int kCells = 8;  // along each side of a window

void add(const WindowSums& from, WindowSums& to) {
  for (std::size_t i = 0; i < to.size(); ++i) to.at(i) += from.at(i);
}

void add_own(double variance, WindowSums& sums) {
  sums[OwnVariance] = variance;
  sums[OwnSquares] = variance * variance;
}

WindowSums sums_of_pixel(const PairSamples& samples, int x, int y, std::size_t channel) {
  WindowSums sums{};
  const auto pixel = samples.pixel_at(x, y);
  if (samples.included[pixel] == 0) return sums;
  const std::size_t i = 3 * pixel + channel;
  sums[Count] = 1;
  sums[Difference] = samples.difference(i);
  sums[Reference] = static_cast<double>(samples.reference[i]);
  sums[Step] = reference_step(samples, x, y, channel);
  const double of_reference = variance_at(samples.reference_variance, i);
  const double expected = (samples.variance_ratio.at(channel) + 1) * of_reference;
  sums[ExpectedVariance] = expected;
  sums[ExpectedSquares] = expected * expected;
  if (samples.noise_source != NoiseSource::Scatter) {
    add_own(variance_at(samples.result_variance, i) + of_reference, sums);
  } else if (x + 1 < samples.width && samples.included[pixel + 1] != 0) {
    const double step = sums[Difference] - samples.difference(i + 3);
    sums[Pairs] = 1;
    add_own(step * step / 2, sums);
  }
  return sums;
}

Cells cells_of_pixels(const PairSamples& samples, std::size_t channel) {
  Cells cells{1, samples.width, samples.height, {}};
  cells.sums.reserve(samples.pixel_count());
  for (int y = 0; y < samples.height; ++y)
    for (int x = 0; x < samples.width; ++x) cells.sums.push_back(sums_of_pixel(samples, x, y, channel));
  return cells;
}

// n x n cells become one; what is left over at the right and lower edge is dropped.
Cells merged(const Cells& cells, int n) {
  Cells out{n * cells.side_px, cells.columns / n, cells.rows / n, {}};
  out.sums.resize(static_cast<std::size_t>(out.columns) * static_cast<std::size_t>(out.rows));
  for (int row = 0; row < n * out.rows; ++row)
    for (int column = 0; column < n * out.columns; ++column)
      add(cells.at(column, row), out.sums[out.index(column / n, row / n)]);
  return out;
}

// Each cell with the 7 below it.
Cells columns_of_windows(const Cells& cells) {
  Cells out{cells.side_px, cells.columns, std::max(0, cells.rows - kCells + 1), {}};
  out.sums.resize(static_cast<std::size_t>(out.columns) * static_cast<std::size_t>(out.rows));
  for (int row = 0; row < out.rows; ++row)
    for (int column = 0; column < out.columns; ++column)
      for (int i = 0; i < kCells; ++i) add(cells.at(column, row + i), out.sums[out.index(column, row)]);
  return out;
}

struct Window {
  WindowSums all{};
  WindowSums within{};  // without its last column of cells, whose right neighbours lie outside
};

Window window_at(const Cells& columns, int column, int row) {
  Window window;
  for (int i = 0; i + 1 < kCells; ++i) add(columns.at(column + i, row), window.within);
  window.all = window.within;
  add(columns.at(column + kCells - 1, row), window.all);
  return window;
}

// Of the sum of the differences over the window; noise_test.h says why the larger one counts. Each pixel is
// in two pairs of neighbours, which are no two numbers: half the degrees of freedom are taken.
PooledVariance noise_over(const Window& window, NoiseSource source) {
  const PooledVariance expected{window.all[ExpectedVariance], window.all[ExpectedSquares]};
  PooledVariance own{window.all[OwnVariance], window.all[OwnSquares]};
  if (source == NoiseSource::Scatter) {
    const double scale = window.all[Count] / std::max(1.0, window.within[Pairs]);
    own = {scale * window.within[OwnVariance], 2 * scale * scale * window.within[OwnSquares]};
  }
  return own.sum >= expected.sum ? own : expected;
}

// Student's quantiles for whole degrees of freedom, rounded down, which makes them larger: one for each
// window would cost more than the windows.
class Reach {
 public:
  explicit Reach(double false_alarms) : false_alarms_(false_alarms) {}

  double of(const PooledVariance& variance) {
    constexpr double kMost = 255;
    const auto degrees = static_cast<std::size_t>(std::clamp(variance.degrees(), 1.0, kMost));
    double& quantile = quantiles_.at(degrees);
    if (quantile == 0) quantile = student_quantile(false_alarms_, static_cast<double>(degrees));
    return quantile * std::sqrt(variance.sum);
  }

 private:
  double false_alarms_;
  std::array<double, 256> quantiles_{};
};

// Mean of the reference over R, G and B of the counted pixels; nothing where noise could make it.
std::optional<double> firm_mean(const PairSamples& samples) {
  constexpr double kFirmness = 10;
  double sum = 0;
  double variance = 0;
  for (std::size_t pixel = 0; pixel < samples.included.size(); ++pixel) {
    if (samples.included[pixel] == 0) continue;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      sum += static_cast<double>(samples.reference[i]);
      variance += variance_at(samples.reference_variance, i);
    }
  }
  if (!(sum > kFirmness * std::sqrt(variance))) return std::nullopt;
  return sum / (3.0 * static_cast<double>(samples.included_count));
}

struct WindowSearch {
  const PairSamples& samples;
  double least_scale;  // by what an error is measured at least
  Reach reach;
  std::optional<WindowError> worst = std::nullopt;
};

// The window's error replaces the worst where it is worse.
void look_at(const Window& window, const Rectangle& where, WindowSearch& search) {
  const double count = window.all[Count];
  if (2 * count < (where.x1 - where.x0) * (where.y1 - where.y0)) return;
  if (!search.worst) search.worst = {0, where};
  const double scale = std::max(search.least_scale, window.all[Reference] / count) * count;
  const double off = std::fabs(window.all[Difference]) - kEdge_px * window.all[Step];
  if (off <= search.worst->value * scale) return;
  const double certain = off - search.reach.of(noise_over(window, search.samples.noise_source));
  if (certain > search.worst->value * scale) search.worst = {certain / scale, where};
}

void look_everywhere(const Cells& cells, WindowSearch& search) {
  const auto columns = columns_of_windows(cells);
  const int side_px = kCells * cells.side_px;
  for (int row = 0; row < columns.rows; ++row)
    for (int column = 0; column + kCells <= columns.columns; ++column) {
      const int x = column * cells.side_px;
      const int y = row * cells.side_px;
      look_at(window_at(columns, column, row), {x, y, x + side_px, y + side_px}, search);
    }
}

// How many windows of one channel there are.
double windows_in(const PairSamples& samples, int side_px) {
  const int step_px = side_px / kCells;
  const auto positions = [&](int length_px) { return std::max(0, length_px / step_px - kCells + 1); };
  return static_cast<double>(positions(samples.width)) * positions(samples.height);
}

}  // namespace

WindowErrors window_errors(const PairSamples& samples) {
  constexpr double kDarkest = 0.1;  // of the image's mean
  WindowErrors errors;
  const auto image_mean = firm_mean(samples);
  if (!image_mean) return errors;
  std::vector<WindowSearch> searches;
  for (const int side_px : kWindows_px) {
    const double least = (side_px == kWindows_px.front() ? 1 : kDarkest) * *image_mean;
    const double windows = std::max(1.0, windows_in(samples, side_px));
    searches.push_back({samples, least, Reach(kFalseAlarmsOfAllWindows / (3 * windows))});
  }
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto px1 = cells_of_pixels(samples, channel);
    const auto px2 = merged(px1, 2);
    look_everywhere(px1, searches[0]);
    look_everywhere(px2, searches[1]);
    look_everywhere(merged(px2, 4), searches[2]);
  }
  for (std::size_t i = 0; i < errors.size(); ++i) errors.at(i) = searches[i].worst;
  return errors;
}

}  // namespace orbs::metrics
