#pragma once

#include "image/image.h"

#include <cstddef>
#include <string>
#include <vector>

namespace orbs::metrics {

/// One channel of two images of one size, as plain numbers: nothing is assumed of what it holds.
struct ChannelDifference {
  std::string name;
  double result_mean = 0;
  double reference_mean = 0;
  double largest = 0;  // |result - reference|; infinity where one of the two is no number
  int x = 0;           // of the first pixel that has it
  int y = 0;
  std::size_t pixels = 0;  // that differ
};

struct ChannelDifferences {
  std::vector<ChannelDifference> both;   // in the order of the result
  std::vector<std::string> only_result;  // names
  std::vector<std::string> only_reference;
};

/// All channels beside R, G, B and their variances, which metrics compare. Both have the same size.
ChannelDifferences channel_differences(const image::Image& result, const image::Image& reference);

}  // namespace orbs::metrics
