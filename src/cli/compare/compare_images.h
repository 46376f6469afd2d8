#pragma once

#include "image/image.h"
#include "metrics/channel_differences.h"
#include "metrics/compare.h"

#include <optional>
#include <string>
#include <vector>

/// What the two forms of orbs compare have in common: two images, and two folders of them.
namespace orbs::cli {

struct CompareOptions {
  std::string first;
  std::string second;
  std::string metric;
  std::string channels;  // layer or channel that is compared; "": what the images say themselves
  std::optional<double> min;
  std::optional<double> max;
  std::string maps;
  std::string page;
  bool all = false;
  bool definitions = false;
  bool as_json = false;
};

struct ComparedImages {
  image::Image first;  // linear
  image::Image second;
  metrics::Comparison comparison;
  metrics::ChannelDifferences channels;  // of those that are no colour
  std::vector<std::string> remarks;      // what was chosen; and what is left beside noise, if they state it
};

/// Reads both and compares them by the metrics that `options` want. InputError where one cannot be read, or
/// they cannot be compared.
ComparedImages compare_images(const std::string& first,
                              const std::string& second,
                              const CompareOptions& options);

/// Also true for a number that does not exist: what cannot be measured is not within a tolerance.
bool is_beyond(const CompareOptions& options, const std::optional<double>& value);

/// "beyond the tolerance: psnr_srgb8, at least 35 is needed"
std::string tolerance_text(const CompareOptions& options);

}  // namespace orbs::cli
