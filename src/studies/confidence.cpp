#include "studies/confidence.h"

#include <algorithm>
#include <cmath>

namespace orbs::studies {

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

Interval ratio_interval(const std::vector<double>& first, const std::vector<double>& second, double outside) {
  const auto a = sample_of(logarithms(first));
  const auto b = sample_of(logarithms(second));
  const double of_a = a.variance / a.count;
  const double of_b = b.variance / b.count;
  const double squares = of_a * of_a / (a.count - 1) + of_b * of_b / (b.count - 1);
  const double degrees = squares > 0 ? (of_a + of_b) * (of_a + of_b) / squares : 1.0;
  const auto logs = student_interval(b.mean - a.mean, std::sqrt(of_a + of_b), degrees, outside);
  return {std::exp(logs.value), std::exp(logs.low), std::exp(logs.high)};
}

}  // namespace orbs::studies
