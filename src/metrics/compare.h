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

struct ErrorMap {
  MapInfo info;
  image::Image image;  // of the images' size; masked pixels are shown as any other
};

/// All that is known about the difference of two images. Unless they are Comparable, there are neither
/// numbers nor maps.
struct Comparison {
  AlignmentReport alignment;
  std::size_t pixels_counted = 0;         // pixels that the mask leaves
  std::vector<Measurement> measurements;  // of the metrics that were computed, in the order of kMetrics
  std::vector<std::string> bias_remarks;  // of describe.h
  std::vector<ErrorMap> maps;             // those of the metrics, each name once, and the signed difference
};

/// Which metrics are computed: by default those that are always computed.
struct MetricSelection {
  bool all = false;                    // also the metrics that are computed on demand
  bool no_others = false;              // only those that `also` names
  std::vector<std::string> also = {};  // names of metrics that are computed in any case
};

/// The numbers and maps of a prepared pair. InputError for a name in `also` that is no metric.
Comparison compare(const ImagePair& pair, const MetricSelection& selection = {});

struct CompareSettings {
  NegativePixels negatives = NegativePixels::Refused;
  int threads = 1;  // 0: all cores; no result depends on it
  bool all = false;
  bool no_others = false;
  std::vector<std::string> also = {};
};

/// Checks, prepares and compares the channels R, G, B of two linear Rec.709 images. Images that cannot be
/// compared are an outcome, not an error; InputError for a mask that does not fit and for a name that is no
/// metric.
Comparison compare(const image::Image& result,
                   const image::Image& reference,
                   const Mask& mask = {},
                   const CompareSettings& settings = {});

/// The measurement of one metric; nullptr when it was not computed. InputError when there is no metric of
/// this name.
const Measurement* find_measurement(const Comparison& comparison, std::string_view metric);

/// The number of one metric; nothing when it has no value here or was not computed. InputError when there is
/// no metric of this name.
std::optional<double> value_of(const Comparison& comparison, std::string_view metric);

}  // namespace orbs::metrics
