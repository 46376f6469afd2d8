#include "metrics/line_error.h"

#include "metrics/common_noise.h"
#include "metrics/firm_mean.h"
#include "metrics/rare_light.h"
#include "metrics/student_reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace orbs::metrics {

namespace {

constexpr double kFalseAlarmsOfAllLines = 1e-4;
constexpr double kEdge_px = 0.2;
constexpr std::size_t kShortest_px = 16;

// What is summed over a line; each is one number per pixel of one channel, 0 where the pixel does not count.
enum Summand {
  Count,
  Difference,
  Reference,
  Step,
  OwnVariance,
  OwnSquares,
  ExpectedVariance,
  ExpectedSquares
};
constexpr std::size_t kSummands = ExpectedSquares + 1;
using Sums = std::array<double, kSummands>;

// How the image lies in the search: its rows are those of the image, or its columns; the lines lean to the
// right.
struct Turn {
  bool is_transposed = false;
  bool is_mirrored = false;
};
constexpr std::array kTurns{Turn{false, false}, Turn{false, true}, Turn{true, false}, Turn{true, true}};

// The sums over all lines that cross `rows_of_a_line` rows from the top of a strip of as many rows, by strip,
// slope and first column. The slope is by how many pixels the last one lies to the right of the first.
struct Lines {
  std::size_t columns = 0;
  std::size_t strips = 0;
  std::size_t rows_of_a_line = 1;
  std::vector<Sums> sums{};

  Sums& at(std::size_t strip, std::size_t slope, std::size_t column) {
    return sums[(strip * rows_of_a_line + slope) * columns + column];
  }
  const Sums& at(std::size_t strip, std::size_t slope, std::size_t column) const {
    return sums[(strip * rows_of_a_line + slope) * columns + column];
  }
};

// The variance of one difference and its square. Where the image does not know its noise it is read off the
// step to the neighbour in the row; each pixel is in two of these, which are no two numbers.
std::pair<double, double> own_noise(const PairSamples& samples, int x, std::size_t sample) {
  if (samples.noise_source != NoiseSource::Scatter) {
    const double own =
        variance_at(samples.result_variance, sample) + variance_at(samples.reference_variance, sample);
    return {own, own * own};
  }
  const std::size_t neighbour = x + 1 < samples.width ? sample + 3 : sample - 3;
  const double step = samples.difference(sample) - samples.difference(neighbour);
  const double own = step * step / 2;
  return {own, 2 * own * own};
}

Sums sums_of_pixel(
    const PairSamples& samples, int x, std::size_t sample, double step, double variance_ratio) {
  const double expected = (variance_ratio + 1) * variance_at(samples.reference_variance, sample);
  const auto [own, own_square] = own_noise(samples, x, sample);
  return {1,
          samples.difference(sample),
          static_cast<double>(samples.reference[sample]),
          step,
          own,
          own_square,
          expected,
          expected * expected};
}

// By pixel of the image, for one channel.
std::vector<Sums> sums_of_pixels(const PairSamples& samples, std::size_t channel) {
  std::vector<Sums> all(samples.pixel_count());
  std::vector<double> steps;
  for (int y = 0; y < samples.height; ++y) {
    reference_steps(samples, y, steps);
    for (int x = 0; x < samples.width; ++x) {
      const auto pixel = samples.pixel_at(x, y);
      if (samples.included[pixel] != 0)
        all[pixel] =
            sums_of_pixel(samples, x, 3 * pixel + channel, steps[3 * static_cast<std::size_t>(x) + channel],
                          samples.variance_ratio.at(channel));
    }
  }
  return all;
}

Lines lines_of_pixels(const PairSamples& samples, const std::vector<Sums>& pixels, const Turn& turn) {
  const auto width = static_cast<std::size_t>(samples.width);
  const auto height = static_cast<std::size_t>(samples.height);
  Lines lines{turn.is_transposed ? height : width, turn.is_transposed ? width : height};
  lines.sums.resize(lines.columns * lines.strips);
  for (std::size_t row = 0; row < lines.strips; ++row)
    for (std::size_t column = 0; column < lines.columns; ++column) {
      const std::size_t along = turn.is_mirrored ? lines.columns - 1 - column : column;
      lines.at(row, 0, column) =
          turn.is_transposed ? pixels[along * width + row] : pixels[row * width + along];
    }
  return lines;
}

void add(const Sums& more, Sums& sums) {
  for (std::size_t i = 0; i < kSummands; ++i) sums.at(i) += more.at(i);
}

// Lines over twice as many rows. What is left of the rows at the lower edge is dropped; what lies beyond the
// right edge adds nothing.
Lines doubled(const Lines& half) {
  Lines lines{half.columns, half.strips / 2, 2 * half.rows_of_a_line};
  lines.sums.resize(lines.columns * lines.strips * lines.rows_of_a_line);
  for (std::size_t strip = 0; strip < lines.strips; ++strip)
    for (std::size_t slope = 0; slope < lines.rows_of_a_line; ++slope) {
      const std::size_t of_half = slope / 2;
      const std::size_t to_lower = slope - of_half;
      for (std::size_t column = 0; column < lines.columns; ++column) {
        Sums& sums = lines.at(strip, slope, column);
        sums = half.at(2 * strip, of_half, column);
        if (column + to_lower < lines.columns) add(half.at(2 * strip + 1, of_half, column + to_lower), sums);
      }
    }
  return lines;
}

struct LineSearch {
  const PairSamples& samples;
  double image_mean;
  StudentReach reach;
  std::size_t channel = 0;
  double common_share = 0;
  LineError worst{};
};

double scale_of(const Sums& sums, double image_mean) {
  return std::max(image_mean * sums[Count], sums[Reference]);
}

double off_by(const Sums& sums) { return std::fabs(sums[Difference]) - kEdge_px * sums[Step]; }

PooledVariance noise_of(const Sums& sums) {
  const PooledVariance own{sums[OwnVariance], sums[OwnSquares]};
  const PooledVariance expected{sums[ExpectedVariance], sums[ExpectedSquares]};
  return own.sum >= expected.sum ? own : expected;
}

// How far noise moves the sum over the line, and what it may lack besides where no sample found it.
double reach_over(const Sums& sums, LineSearch& search) {
  const auto& samples = search.samples;
  auto noise = noise_of(sums);
  noise.scale(samples.area_noise.over_8px.at(search.channel));
  const double reach = std::hypot(search.reach.of(noise), search.common_share * sums[Reference]);
  if (sums[Difference] >= 0) return reach;
  const PooledVariance own{sums[OwnVariance], sums[OwnSquares]};
  return std::max(reach, unseen_light(samples.hit_size.at(search.channel), own, search.reach.false_alarms()));
}

// Nearly no line is worse than the worst, and that is told without the degrees of freedom and quantiles.
bool may_be_worse(const Sums& sums, LineSearch& search) {
  const double noise = std::max(sums[OwnVariance], sums[ExpectedVariance]);
  return off_by(sums) - search.reach.least_quantile() * std::sqrt(noise) >
         search.worst.value * scale_of(sums, search.image_mean);
}

// Of the image, in which the lines may lie turned.
Rectangle rectangle_of(
    const Lines& lines, std::size_t strip, std::size_t slope, std::size_t column, const Turn& turn) {
  std::size_t left = column;
  std::size_t right = std::min(lines.columns, column + slope + 1);
  if (turn.is_mirrored) {
    std::swap(left, right);
    left = lines.columns - left;
    right = lines.columns - right;
  }
  const std::size_t top = strip * lines.rows_of_a_line;
  const std::size_t bottom = top + lines.rows_of_a_line;
  const auto px = [](std::size_t at) { return static_cast<int>(at); };
  if (turn.is_transposed) return {px(top), px(left), px(bottom), px(right)};
  return {px(left), px(top), px(right), px(bottom)};
}

void look_at_lines(const Lines& lines, const Turn& turn, LineSearch& search) {
  for (std::size_t strip = 0; strip < lines.strips; ++strip)
    for (std::size_t slope = 0; slope < lines.rows_of_a_line; ++slope)
      for (std::size_t column = 0; column < lines.columns; ++column) {
        const Sums& sums = lines.at(strip, slope, column);
        if (2 * sums[Count] < static_cast<double>(lines.rows_of_a_line) || !may_be_worse(sums, search))
          continue;
        const double scale = scale_of(sums, search.image_mean);
        const double certain = off_by(sums) - reach_over(sums, search);
        if (certain > search.worst.value * scale)
          search.worst = {certain / scale, rectangle_of(lines, strip, slope, column, turn)};
      }
}

// As many as there are starts and slopes in each turn, once for every length.
double lines_in(const PairSamples& samples) {
  const double pixels = static_cast<double>(samples.pixel_count());
  const double lengths = std::log2(std::max(samples.width, samples.height)) - 3;
  return 3 * static_cast<double>(kTurns.size()) * pixels * std::max(1.0, lengths);
}

}  // namespace

std::optional<LineError> line_error(const PairSamples& samples) {
  const auto mean = firm_mean(samples);
  if (!mean || std::min(samples.width, samples.height) < 2 ||
      std::max(samples.width, samples.height) < static_cast<int>(kShortest_px))
    return std::nullopt;
  LineSearch search{samples, *mean,
                    StudentReach(kFalseAlarmsOfAllLines / (lines_in(samples) * samples.looks))};
  for (search.channel = 0; search.channel < 3; ++search.channel) {
    const auto pixels = sums_of_pixels(samples, search.channel);
    search.common_share = common_share(samples, search.channel);
    for (const Turn& turn : kTurns) {
      auto lines = lines_of_pixels(samples, pixels, turn);
      while (lines.strips > 1) {
        lines = doubled(lines);
        if (lines.rows_of_a_line >= kShortest_px) look_at_lines(lines, turn, search);
      }
    }
  }
  return search.worst;
}

}  // namespace orbs::metrics
