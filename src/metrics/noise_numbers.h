#pragma once

#include "metrics/noise_test.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::metrics {

/// One number of a NoiseTest with what it means, as MetricInfo is for the metrics.
struct NoiseNumber {
  std::string_view name;
  std::string_view unit;
  std::string_view definition;
  bool is_signed = false;  // nearer to zero is better; else lower is better
  double value = 0;
  std::optional<double> low;  // ends of its interval, where it has one
  std::optional<double> high;
  std::optional<Rectangle> where;  // the pixels that it is of, where it is not of all
};

/// Everything that the test found, in a fixed order. What it could not say is left out.
std::vector<NoiseNumber> noise_numbers(const NoiseTest& test);

/// That the means, else the blocks, differ by more than noise: what a reader must be told of an image that
/// passes. "" when they do not. Images of two renderers that are both right differ at the edges of objects,
/// so their squares are left to whom they matter to.
std::string bias_remark(const NoiseTest& test);

/// All that is_biased saw: the remark, else the squares. "" when it saw nothing.
std::string bias_message(const NoiseTest& test);

}  // namespace orbs::metrics
