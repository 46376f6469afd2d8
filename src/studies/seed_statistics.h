#pragma once

#include "base/statistics.h"
#include "image/image.h"
#include "json/writer.h"

#include <optional>
#include <string_view>
#include <vector>

namespace orbs::studies {

/// The middle of some measurements and the ends between which all of them lie.
struct Spread {
  double median = 0;  // of an even number: the mean of the two in the middle
  double least = 0;
  double most = 0;
};

/// Nothing when there are no values.
std::optional<Spread> spread_of(std::vector<double> values);

/// As the member `name` of an object; null for nothing.
void write_spread(json::Writer& out, const char* name, const std::optional<Spread>& spread);

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

/// The logarithm of a ratio, or of anything above 0, as it is known.
struct LogRatio {
  double value = 0;
  double variance = 0;  // of the value
  double degrees = 1;   // with which the variance is known
};

/// The sum of independent logarithms, with Welch's degrees.
LogRatio sum_of(const std::vector<LogRatio>& logs);

/// The mean of at least one logarithm. Its variance is what the variances of the logarithms make: it says
/// nothing of others.
LogRatio mean_within(const std::vector<LogRatio>& logs);

/// The mean of at least one logarithm, such as those of several scenes. Its variance is that of their
/// scatter, so it speaks of other scenes of the kind as well; of a single one it is its own.
LogRatio mean_over(const std::vector<LogRatio>& logs);

/// The one interval that ratios have, in every table and on every page: Student's of the logarithm.
Interval ratio_interval(const LogRatio& log, double outside = kOutside);

/// The ratio of the geometric means of two samples, second / first. All values are above 0, and there are at
/// least two of each.
LogRatio log_ratio(const std::vector<double>& first, const std::vector<double>& second);

/// By Welch's test on the logarithms.
Interval ratio_interval(const std::vector<double>& first,
                        const std::vector<double>& second,
                        double outside = kOutside);

/// The noise of one image, estimated only from several images with different seeds. It needs no reference and
/// measures every renderer alike; it cannot show an error that all seeds share.
struct SeedNoise {
  double relative_mse = 0;
  double psnr_srgb8_db = 0;
};

inline constexpr std::string_view kRelativeMseDefinition =
    "mean over the channels R, G, B of all pixels of s^2 / (m^2 + 0.01); s^2: unbiased variance over "
    "seeds of the linear Rec.709 value; m: mean of the images of all renderers and seeds";
inline constexpr std::string_view kSeedPsnrDefinition =
    "10 log10(255^2 / (MSE / 2)); MSE: that of psnr_srgb8 between images of two seeds, of which each has "
    "half, mean over successive seeds";

/// From at least two images of the same sample count; `mean`, of their size, gives the denominators.
SeedNoise noise_of_seeds(const std::vector<image::Image>& images, const image::Image& mean, int threads);

}  // namespace orbs::studies
