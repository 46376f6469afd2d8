#include "studies/seed_statistics.h"

#include "metrics/compare.h"
#include "metrics/psnr.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace orbs::studies {

std::optional<Spread> spread_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t upper = values.size() / 2;
  const std::size_t lower = (values.size() - 1) / 2;
  return Spread{(values[lower] + values[upper]) / 2, values.front(), values.back()};
}

void write_spread(json::Writer& out, const char* name, const std::optional<Spread>& spread) {
  out.key(name);
  if (!spread) {
    out.null();
    return;
  }
  out.begin_object()
      .member("median", spread->median)
      .member("least", spread->least)
      .member("most", spread->most)
      .end_object();
}

namespace {

// The probability that at most `most` of `count` values lie below the median.
double binomial_tail(int most, int count) {
  double sum = 0;
  double term = std::pow(0.5, count);
  for (int k = 0; k <= most; ++k) {
    sum += term;
    term *= static_cast<double>(count - k) / (k + 1);
  }
  return sum;
}

std::vector<double> logarithms(const std::vector<double>& values) {
  std::vector<double> logs;
  logs.reserve(values.size());
  for (const double value : values) logs.push_back(std::log(value));
  return logs;
}

}  // namespace

Sample sample_of(const std::vector<double>& values) {
  Sample sample;
  sample.count = static_cast<int>(values.size());
  for (const double value : values) sample.mean += value / sample.count;
  for (const double value : values) sample.variance += (value - sample.mean) * (value - sample.mean);
  sample.variance = sample.count > 1 ? sample.variance / (sample.count - 1) : 0.0;
  return sample;
}

Interval mean_interval(const std::vector<double>& values) {
  const auto sample = sample_of(values);
  return student_interval(sample.mean, std::sqrt(sample.variance / sample.count), sample.count - 1, kOutside);
}

Interval median_interval(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto count = values.size();
  const double median = (values[(count - 1) / 2] + values[count / 2]) / 2;
  std::size_t skipped = 0;  // values left out at each end
  while (2 * (skipped + 1) < count &&
         2 * binomial_tail(static_cast<int>(skipped) + 1, static_cast<int>(count)) <= kOutside)
    ++skipped;
  return {median, values[skipped], values[count - 1 - skipped]};
}

LogRatio sum_of(const std::vector<LogRatio>& logs) {
  LogRatio sum;
  double squares = 0;
  for (const auto& log : logs) {
    sum.value += log.value;
    sum.variance += log.variance;
    squares += log.variance * log.variance / log.degrees;
  }
  if (squares > 0) sum.degrees = sum.variance * sum.variance / squares;
  return sum;
}

LogRatio mean_within(const std::vector<LogRatio>& logs) {
  auto mean = sum_of(logs);
  const auto count = static_cast<double>(logs.size());
  mean.value /= count;
  mean.variance /= count * count;
  return mean;
}

LogRatio mean_over(const std::vector<LogRatio>& logs) {
  if (logs.size() == 1) return logs.front();
  std::vector<double> values;
  for (const auto& log : logs) values.push_back(log.value);
  const auto sample = sample_of(values);
  return {sample.mean, sample.variance / sample.count, static_cast<double>(sample.count - 1)};
}

Interval ratio_interval(const LogRatio& log, double outside) {
  const auto logs = student_interval(log.value, std::sqrt(log.variance), log.degrees, outside);
  return {std::exp(logs.value), std::exp(logs.low), std::exp(logs.high)};
}

LogRatio log_ratio(const std::vector<double>& first, const std::vector<double>& second) {
  const auto a = sample_of(logarithms(first));
  const auto b = sample_of(logarithms(second));
  return sum_of({{b.mean, b.variance / b.count, static_cast<double>(b.count - 1)},
                 {-a.mean, a.variance / a.count, static_cast<double>(a.count - 1)}});
}

Interval ratio_interval(const std::vector<double>& first, const std::vector<double>& second, double outside) {
  return ratio_interval(log_ratio(first, second), outside);
}

namespace {

double relative_mse(const std::vector<image::Image>& images, const image::Image& mean) {
  constexpr double kFloor = 0.01;  // keeps black pixels from outweighing all others
  const auto count = static_cast<double>(images.size());
  double total = 0;
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
    double own_mean = 0;
    for (const auto& image : images) own_mean += static_cast<double>(image.pixels[i]) / count;
    double squares = 0;
    for (const auto& image : images) {
      const double difference = static_cast<double>(image.pixels[i]) - own_mean;
      squares += difference * difference;
    }
    const double level = static_cast<double>(mean.pixels[i]);
    total += squares / (count - 1) / (level * level + kFloor);
  }
  return total / static_cast<double>(mean.pixels.size());
}

}  // namespace

SeedNoise noise_of_seeds(const std::vector<image::Image>& images, const image::Image& mean, int threads) {
  SeedNoise noise;
  noise.relative_mse = relative_mse(image::colours_of(images), mean);
  double mse = 0;
  for (std::size_t i = 1; i < images.size(); ++i) {
    const auto comparison = metrics::compare(images[i - 1], images[i], {},
                                             {.negatives = metrics::NegativePixels::Allowed,
                                              .threads = threads,
                                              .no_others = true,
                                              .also = {"psnr_srgb8"}});
    const double psnr = metrics::value_of(comparison, "psnr_srgb8").value();
    mse += std::pow(10, -psnr / 10) * 255 * 255;
  }
  noise.psnr_srgb8_db = metrics::psnr_db(255, mse / static_cast<double>(images.size() - 1) / 2);
  return noise;
}

}  // namespace orbs::studies
