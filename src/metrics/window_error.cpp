#include "metrics/window_error.h"

#include "metrics/common_noise.h"
#include "metrics/firm_mean.h"
#include "metrics/rare_light.h"
#include "metrics/student_reach.h"

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
constexpr std::size_t kCells = 8;  // along each side of a window

// Over how many columns of a window's cells each summand is summed. Of pairs the last one is left out, whose
// right neighbours lie outside.
using Columns = std::array<std::size_t, kSummands>;

Columns columns_of(NoiseSource source) {
  Columns columns{};
  columns.fill(kCells);
  columns[Pairs] = 0;
  if (source == NoiseSource::Scatter)
    columns[Pairs] = columns[OwnVariance] = columns[OwnSquares] = kCells - 1;
  return columns;
}

// The sums of square cells. A window is made of 8 x 8 of them: sums over its own cells alone, because a table
// of sums over the whole image loses the digits of what lies beyond a firefly. Each row holds one summand
// after the other, so that several windows are summed in one instruction.
struct Cells {
  int side_px = 1;
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> sums{};

  double* at(std::size_t row, std::size_t summand) {
    return sums.data() + (row * kSummands + summand) * columns;
  }
  const double* at(std::size_t row, std::size_t summand) const {
    return sums.data() + (row * kSummands + summand) * columns;
  }
};

Cells no_cells(int side_px, std::size_t columns, std::size_t rows) {
  return {side_px, columns, rows, std::vector<double>(columns * rows * kSummands)};
}

struct CellSample {
  std::size_t row = 0;
  std::size_t column = 0;
  std::size_t sample = 0;  // of the channel that is looked at
};

void set_own(const CellSample& site, double variance, Cells& cells) {
  cells.at(site.row, OwnVariance)[site.column] = variance;
  cells.at(site.row, OwnSquares)[site.column] = variance * variance;
}

void set_variances(const PairSamples& samples, const CellSample& site, double variance_ratio, Cells& cells) {
  const double of_reference = variance_at(samples.reference_variance, site.sample);
  const double expected = (variance_ratio + 1) * of_reference;
  cells.at(site.row, ExpectedVariance)[site.column] = expected;
  cells.at(site.row, ExpectedSquares)[site.column] = expected * expected;
  if (samples.noise_source != NoiseSource::Scatter)
    set_own(site, variance_at(samples.result_variance, site.sample) + of_reference, cells);
}

// The right neighbour counts as well.
void set_pair(const PairSamples& samples, const CellSample& site, Cells& cells) {
  const double step = samples.difference(site.sample) - samples.difference(site.sample + 3);
  cells.at(site.row, Pairs)[site.column] = 1;
  set_own(site, step * step / 2, cells);
}

// Overwrites the cells, which are those of pixels and in which pixels that do not count are 0.
void set_pixels(const PairSamples& samples, std::size_t channel, Cells& cells) {
  const bool is_scatter = samples.noise_source == NoiseSource::Scatter;
  const double variance_ratio = samples.variance_ratio.at(channel);
  std::vector<double> steps;
  std::size_t pixel = 0;
  for (std::size_t row = 0; row < cells.rows; ++row) {
    reference_steps(samples, static_cast<int>(row), steps);
    for (std::size_t column = 0; column < cells.columns; ++column, ++pixel) {
      if (samples.included[pixel] == 0) continue;
      const CellSample site{row, column, 3 * pixel + channel};
      cells.at(row, Count)[column] = 1;
      cells.at(row, Difference)[column] = samples.difference(site.sample);
      cells.at(row, Reference)[column] = static_cast<double>(samples.reference[site.sample]);
      cells.at(row, Step)[column] = steps[3 * column + channel];
      set_variances(samples, site, variance_ratio, cells);
      if (is_scatter && column + 1 < cells.columns && samples.included[pixel + 1] != 0)
        set_pair(samples, site, cells);
    }
  }
}

// n x n cells become one; what is left over at the right and lower edge is dropped.
Cells merged(const Cells& cells, std::size_t n) {
  auto out = no_cells(static_cast<int>(n) * cells.side_px, cells.columns / n, cells.rows / n);
  for (std::size_t row = 0; row < n * out.rows; ++row)
    for (std::size_t summand = 0; summand < kSummands; ++summand) {
      const double* const from = cells.at(row, summand);
      double* const to = out.at(row / n, summand);
      for (std::size_t column = 0; column < out.columns; ++column)
        for (std::size_t i = 0; i < n; ++i) to[column] += from[n * column + i];
    }
  return out;
}

// The sums of the windows that begin in one row of cells.
class WindowRow {
 public:
  WindowRow(const Cells& cells, const Columns& columns)
      : cells_(cells),
        columns_(columns),
        count_(cells.columns - kCells + 1),
        below_(cells.columns),
        sums_(count_ * kSummands) {}

  void sum(std::size_t row) {
    for (std::size_t summand = 0; summand < kSummands; ++summand) {
      if (columns_.at(summand) == 0) continue;
      add_up<kCells>(cells_.at(row, summand), kSummands * cells_.columns, below_.size(), below_.data());
      double* const sums = &sums_[summand * count_];
      if (columns_.at(summand) == kCells) {
        add_up<kCells>(below_.data(), 1, count_, sums);
      } else {
        add_up<kCells - 1>(below_.data(), 1, count_, sums);
      }
    }
  }

  std::size_t count() const { return count_; }
  double of(Summand summand, std::size_t window) const { return sums_[summand * count_ + window]; }

 private:
  // Of each of `count` numbers and those that lie n strides on, the sum of the first N, in this order.
  template <std::size_t N>
  static void add_up(const double* from, std::size_t stride, std::size_t count, double* __restrict to) {
    for (std::size_t i = 0; i < count; ++i) {
      double sum = 0;
      for (std::size_t n = 0; n < N; ++n) sum += from[i + n * stride];
      to[i] = sum;
    }
  }

  const Cells& cells_;
  Columns columns_;
  std::size_t count_;
  std::vector<double> below_;  // each cell with the 7 below it
  std::vector<double> sums_;
};

// What a sum over the pairs that lie in a window is multiplied by.
double pair_scale(const WindowRow& windows, std::size_t i, NoiseSource source) {
  if (source != NoiseSource::Scatter) return 1;
  return windows.of(Count, i) / std::max(1.0, windows.of(Pairs, i));
}

double own_noise_over(const WindowRow& windows, std::size_t i, NoiseSource source) {
  return pair_scale(windows, i, source) * windows.of(OwnVariance, i);
}

// Of the sum of the differences over the window; noise_test.h says why the larger one counts. Each pixel is
// in two pairs of neighbours, which are no two numbers: half the degrees of freedom are taken.
PooledVariance noise_over(const WindowRow& windows, std::size_t i, NoiseSource source) {
  const PooledVariance expected{windows.of(ExpectedVariance, i), windows.of(ExpectedSquares, i)};
  const double scale = pair_scale(windows, i, source);
  const double squares = source == NoiseSource::Scatter ? 2 * scale * scale : 1;
  const PooledVariance own{own_noise_over(windows, i, source), squares * windows.of(OwnSquares, i)};
  return own.sum >= expected.sum ? own : expected;
}

// Of the reference, by the means of R, G and B of the counted pixels.
double bright_level(const PairSamples& samples) {
  constexpr double kShare = 0.95;
  std::vector<double> levels;
  for (std::size_t pixel = 0; pixel < samples.included.size(); ++pixel)
    if (samples.included[pixel] != 0)
      levels.push_back((static_cast<double>(samples.reference[3 * pixel]) +
                        static_cast<double>(samples.reference[3 * pixel + 1]) +
                        static_cast<double>(samples.reference[3 * pixel + 2])) /
                       3);
  const auto at = static_cast<std::ptrdiff_t>(kShare * static_cast<double>(levels.size() - 1));
  std::nth_element(levels.begin(), levels.begin() + at, levels.end());
  return levels[static_cast<std::size_t>(at)];
}

struct WindowSearch {
  const PairSamples& samples;
  double least_scale;  // by what an error is measured at least
  StudentReach reach;
  std::optional<double> least_scale_to_pass;  // where windows are to be shown right, too
  int side_px;
  std::size_t channel = 0;  // that is looked at
  double inflation = 1;  // of the variance of a window, and how far noise moves the mean of the whole image,
  double common_share = 0;  // as a share of it: what pixels have in common (common_noise.h)
  std::optional<WindowError> worst = std::nullopt;
};

double scale_of(const WindowRow& windows, std::size_t i, double least_scale) {
  const double count = windows.of(Count, i);
  return std::max(least_scale, windows.of(Reference, i) / count) * count;
}

double off_by(const WindowRow& windows, std::size_t i) {
  return std::fabs(windows.of(Difference, i)) - kEdge_px * windows.of(Step, i);
}

// Whether the window's error may be worse than the worst. Nearly none is, and that is told of all without the
// degrees of freedom and the quantiles, of which one costs as much as 10,000 windows.
struct Candidates {
  std::vector<double> scale, most;

  explicit Candidates(std::size_t count) : scale(count), most(count) {}

  void look(const WindowRow& windows, WindowSearch& search) {
    const double quantile = search.reach.least_quantile();
    const double least_scale = search.least_scale;
    const auto source = search.samples.noise_source;
    for (std::size_t i = 0; i < scale.size(); ++i) {
      scale[i] = scale_of(windows, i, least_scale);
      const double noise = std::max(own_noise_over(windows, i, source), windows.of(ExpectedVariance, i));
      most[i] = off_by(windows, i) - quantile * std::sqrt(noise);
    }
  }
  bool may_be_worse(std::size_t i, const std::optional<WindowError>& worst) const {
    return !worst || most[i] > worst->value * scale[i];
  }
};

// How far noise moves the sum over the window, and what it may lack besides where no sample found it.
double reach_over(const WindowRow& windows, std::size_t i, const Rectangle& where, WindowSearch& search) {
  const double own =
      std::sqrt(search.inflation) * search.reach.of(noise_over(windows, i, search.samples.noise_source));
  const double reach = std::hypot(own, search.common_share * windows.of(Reference, i));
  if (windows.of(Difference, i) >= 0) return reach;
  return std::max(reach, unseen_light(search.samples, where, search.channel, search.reach.false_alarms()));
}

// The window's error replaces the worst where it is worse.
void look_at(const WindowRow& windows, std::size_t i, const Rectangle& where, WindowSearch& search) {
  if (2 * windows.of(Count, i) < (where.x1 - where.x0) * (where.y1 - where.y0)) return;
  if (!search.worst) search.worst = {0, where};
  const double scale = scale_of(windows, i, search.least_scale);
  const double off = off_by(windows, i);
  if (off <= search.worst->value * scale) return;
  const double certain = off - reach_over(windows, i, where, search);
  if (certain <= search.worst->value * scale) return;
  search.worst->value = certain / scale;
  search.worst->where = where;
}

// What is seen of an error, and what the result's own noise hides of it besides: by its own variances, as for
// the mean, because a pass that waits for light which the image has not met waits for ever.
double largest_error(const WindowRow& windows, std::size_t i, WindowSearch& search) {
  const double of_reference =
      windows.of(ExpectedVariance, i) / (search.samples.variance_ratio.at(search.channel) + 1);
  const double own = own_noise_over(windows, i, search.samples.noise_source);
  const double reach = kErrorsToPass * std::sqrt(search.inflation * std::max(0.0, own - of_reference));
  return (std::max(0.0, off_by(windows, i)) + reach) / scale_of(windows, i, *search.least_scale_to_pass);
}

void look_at_largest(const WindowRow& windows, WindowSearch& search) {
  const double fewest = search.side_px * search.side_px / 2.0;
  for (std::size_t i = 0; i < windows.count(); ++i)
    if (windows.of(Count, i) >= fewest && search.worst)
      search.worst->largest = std::max(search.worst->largest, largest_error(windows, i, search));
}

void look_everywhere(const Cells& cells, WindowSearch& search) {
  if (cells.columns < kCells || cells.rows < kCells) return;
  WindowRow windows(cells, columns_of(search.samples.noise_source));
  Candidates candidates(windows.count());
  const int side_px = static_cast<int>(kCells) * cells.side_px;
  for (std::size_t row = 0; row + kCells <= cells.rows; ++row) {
    windows.sum(row);
    candidates.look(windows, search);
    const int y = static_cast<int>(row) * cells.side_px;
    for (std::size_t i = 0; i < windows.count(); ++i) {
      if (!candidates.may_be_worse(i, search.worst)) continue;
      const int x = static_cast<int>(i) * cells.side_px;
      look_at(windows, i, {x, y, x + side_px, y + side_px}, search);
    }
    if (search.least_scale_to_pass) look_at_largest(windows, search);
  }
}

void set_channel(std::size_t channel, WindowSearch& search) {
  const auto& samples = search.samples;
  const auto& area = samples.area_noise;
  search.channel = channel;
  search.inflation = (search.side_px == kWindows_px.front() ? area.over_8px : area.over_16px).at(channel);
  search.common_share = common_share(samples, channel);
}

// How many windows of one channel there are.
double windows_in(const PairSamples& samples, int side_px) {
  constexpr int kAlong = static_cast<int>(kCells);
  const int step_px = side_px / kAlong;
  const auto positions = [&](int length_px) { return std::max(0, length_px / step_px - kAlong + 1); };
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
    const bool is_smallest = side_px == kWindows_px.front();
    const double least = (is_smallest ? 1 : kDarkest) * *image_mean;
    const double windows = std::max(1.0, windows_in(samples, side_px));
    searches.push_back({samples, least,
                        StudentReach(kFalseAlarmsOfAllWindows / (3 * windows * samples.looks)), std::nullopt,
                        side_px});
    if (samples.looks > 1 && !is_smallest)
      searches.back().least_scale_to_pass = std::max(*image_mean, bright_level(samples) / 2);
  }
  auto px1 = no_cells(1, static_cast<std::size_t>(samples.width), static_cast<std::size_t>(samples.height));
  for (std::size_t channel = 0; channel < 3; ++channel) {
    set_pixels(samples, channel, px1);
    for (auto& search : searches) set_channel(channel, search);
    const auto px2 = merged(px1, 2);
    look_everywhere(px1, searches[0]);
    look_everywhere(px2, searches[1]);
    look_everywhere(merged(px2, 4), searches[2]);
  }
  for (std::size_t i = 0; i < errors.size(); ++i) errors.at(i) = searches[i].worst;
  return errors;
}

}  // namespace orbs::metrics
