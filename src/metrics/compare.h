#pragma once

#include "image/image.h"
#include "metrics/alignment.h"
#include "metrics/mask.h"
#include "metrics/metric.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::metrics {

struct Measurement {
  const MetricInfo* metric;  // a line of kMetrics
  std::optional<double>
      value;  // +infinity for the PSNR of equal images; nothing where the metric is not defined
  std::optional<Rectangle> where = {};  // the pixels that it is of, where it is not of all
};

struct ErrorMap {
  MapInfo info;
  image::Image image;  // of the images' size; masked pixels are shown as any other
};

/// All that is known about the difference of two images. Unless they are Comparable, there are no numbers
/// and no maps.
struct Comparison {
  AlignmentReport alignment;
  std::size_t pixels_counted = 0;         // pixels that the mask leaves
  std::vector<Measurement> measurements;  // of the metrics that were computed, in the order of kMetrics
  std::vector<ErrorMap> maps;             // those of the metrics, each name once, and the signed difference
};

struct CompareSettings {
  NegativePixels negatives = NegativePixels::Refused;
  int threads = 1;                     // 0: all cores; no result depends on it
  bool all = false;                    // also the metrics that are computed on demand
  bool no_others = false;              // only what `also` names
  std::vector<std::string> also = {};  // names of metrics that are computed in any case
};

/// Compares the channels R, G, B of two linear Rec.709 images by the metrics of kMetrics that are always
/// computed and those that the settings ask for. What makes them incomparable is an outcome, not an error;
/// InputError only for a mask that does not fit and for a name that is no metric.
Comparison compare(const image::Image& result,
                   const image::Image& reference,
                   const Mask& mask = {},
                   const CompareSettings& settings = {});

/// The number of one metric. InputError when there is no metric of this name; nothing when it has no value
/// here or was not computed.
std::optional<double> value_of(const Comparison& comparison, std::string_view metric);

}  // namespace orbs::metrics
