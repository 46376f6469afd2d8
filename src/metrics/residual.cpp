#include "metrics/residual.h"

#include "base/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace orbs::metrics {

namespace {

double brightness_at(const PairSamples& samples, std::size_t pixel) {
  const float* rgb = &samples.reference[3 * pixel];
  return (static_cast<double>(rgb[0]) + static_cast<double>(rgb[1]) + static_cast<double>(rgb[2])) / 3;
}

double deviation_at(const PairSamples& samples, std::size_t pixel) {
  double sum = 0;
  for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) sum += variance_at(samples.reference_variance, i);
  return std::sqrt(sum / 3);
}

// Of each pixel.
struct Levels {
  std::vector<double> brightness, deviation;
};

Levels levels_of(const PairSamples& samples) {
  Levels levels{std::vector<double>(samples.pixel_count()), std::vector<double>(samples.pixel_count())};
  for (std::size_t pixel = 0; pixel < samples.pixel_count(); ++pixel) {
    levels.brightness[pixel] = brightness_at(samples, pixel);
    levels.deviation[pixel] = deviation_at(samples, pixel);
  }
  return levels;
}

// Of the pixels around one that is not at the edge of the image.
bool is_smooth(const Levels& levels, std::size_t pixel, std::size_t width) {
  constexpr double kChange = 0.1;
  constexpr double kStandardDeviations = 4;  // the range of nine normally distributed numbers is 3 of them
  double least = levels.brightness[pixel];
  double most = least;
  double deviation = 0;
  for (const std::size_t first : {pixel - width - 1, pixel - 1, pixel + width - 1})
    for (std::size_t i = first; i < first + 3; ++i) {
      least = std::min(least, levels.brightness[i]);
      most = std::max(most, levels.brightness[i]);
      deviation = std::max(deviation, levels.deviation[i]);
    }
  return most - least <= kChange * std::max(0.0, most) + kStandardDeviations * deviation;
}

// The sum of the three channels, whose noise is not independent.
double difference_of(const PairSamples& samples, std::size_t pixel) {
  return samples.difference(3 * pixel) + samples.difference(3 * pixel + 1) +
         samples.difference(3 * pixel + 2);
}

// Differences over what the noise of a path tracer is nearly in proportion to, so that bright places do not
// rule; 0 where a pixel does not count.
std::vector<double> relative_differences(const PairSamples& samples,
                                         const std::vector<std::uint8_t>& smooth) {
  constexpr double kFloor = 0.1;
  double mean = 0;
  for (std::size_t pixel = 0; pixel < smooth.size(); ++pixel)
    mean += std::fabs(brightness_at(samples, pixel)) / static_cast<double>(smooth.size());
  std::vector<double> differences(smooth.size());
  for (std::size_t pixel = 0; pixel < smooth.size(); ++pixel)
    if (smooth[pixel] != 0)
      differences[pixel] =
          difference_of(samples, pixel) / (std::fabs(brightness_at(samples, pixel)) + kFloor * mean);
  return differences;
}

// The sum over the products of all pairs, by blocks: where pixels are independent its blocks have the mean 0,
// and their squares tell its variance.
struct Products {
  double sum = 0;
  double squares = 0;  // of the differences in the pairs, their mean
  double pairs = 0;
  PooledVariance variance;
};

Products products_of(const PairSamples& samples,
                     const std::vector<double>& differences,
                     const std::vector<std::uint8_t>& smooth,
                     const Correlation& lag) {
  Products products;
  for (const Rectangle& block : blocks_of(samples)) {
    double sum = 0;
    for (int y = block.y0; y < std::min(block.y1, samples.height - lag.dy); ++y)
      for (int x = block.x0; x < std::min(block.x1, samples.width - lag.dx); ++x) {
        const auto a = samples.pixel_at(x, y);
        const auto b = samples.pixel_at(x + lag.dx, y + lag.dy);
        if (smooth[a] == 0 || smooth[b] == 0) continue;
        sum += differences[a] * differences[b];
        products.squares += (differences[a] * differences[a] + differences[b] * differences[b]) / 2;
        ++products.pairs;
      }
    products.sum += sum;
    products.variance.add(sum * sum);
  }
  return products;
}

}  // namespace

std::vector<std::uint8_t> smooth_pixels(const PairSamples& samples) {
  std::vector<std::uint8_t> smooth(samples.included.size(), 0);
  const auto levels = levels_of(samples);
  for (int y = 1; y + 1 < samples.height; ++y)
    for (int x = 1; x + 1 < samples.width; ++x) {
      const auto pixel = samples.pixel_at(x, y);
      smooth[pixel] = static_cast<std::uint8_t>(
          samples.included[pixel] != 0 && is_smooth(levels, pixel, static_cast<std::size_t>(samples.width)));
    }
  return smooth;
}

std::optional<Correlation> strongest_correlation(const PairSamples& samples,
                                                 const std::vector<std::uint8_t>& smooth,
                                                 double false_alarms) {
  // An operation of floats rounds by 2^-24, alike in all pixels of an even surface; the roundings of a
  // hundred in a row add up to less than this in each of the three channels.
  constexpr double kRounding = 3 * 0x1p-17;
  constexpr double kNegligibleCorrelation = 0.05;
  constexpr std::array<std::array<int, 2>, 5> kLags{{{1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}}};
  if (std::count(smooth.begin(), smooth.end(), 1) < kFewestSmoothPixels) return std::nullopt;
  const auto differences = relative_differences(samples, smooth);
  std::optional<Correlation> strongest;
  for (const auto& [dx, dy] : kLags) {
    Correlation found{dx, dy};
    const auto products = products_of(samples, differences, smooth, found);
    if (products.squares <= kRounding * kRounding * products.pairs) continue;
    const double reach = student_quantile(false_alarms / kLags.size(), products.variance.degrees()) *
                         std::sqrt(products.variance.sum) / products.squares;
    found.value = products.sum / products.squares;
    found.low = found.value - reach;
    found.high = found.value + reach;
    if (std::fabs(found.value) - reach <= kNegligibleCorrelation) continue;
    if (!strongest || std::fabs(found.value) > std::fabs(strongest->value)) strongest = found;
  }
  return strongest;
}

}  // namespace orbs::metrics
