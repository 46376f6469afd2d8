#pragma once

#include "base/interval.h"

#include <vector>

namespace orbs::studies {

/// Intervals of studies hold 95 %: the probability that one misses.
inline constexpr double kOutside = 0.05;

/// What repeated measurements of one number say of it.
struct Sample {
  double mean = 0;
  double variance = 0;  // unbiased, of one measurement
  int count = 0;
};

/// Of at least one value; the variance of a single one is 0.
Sample sample_of(const std::vector<double>& values);

/// The mean of the values, which are taken to be normally distributed.
Interval mean_interval(const std::vector<double>& values);

/// The median of at least one value between two order statistics, for any distribution: the binomial
/// distribution says how often they enclose it. Fewer than six values cannot reach 95 %; the interval then is
/// all of them (four: 87.5 %).
Interval median_interval(std::vector<double> values);

/// The ratio of the geometric means of two samples, second / first, by Welch's test on the logarithms. All
/// values are above 0, and there are at least two of each.
Interval ratio_interval(const std::vector<double>& first,
                        const std::vector<double>& second,
                        double outside = kOutside);

}  // namespace orbs::studies
