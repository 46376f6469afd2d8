#pragma once

#include "image/image.h"
#include "metrics/image_pair.h"
#include "metrics/mask.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::metrics {

/// Why a metric has no value for a pair, which decides what a gate makes of it. Undefined: the definition
/// gives no number here, so the gate is inconclusive. NothingInReference: the reference has nothing of what
/// the metric compares, so the gate is met. MissingInResult: the reference has it and the result lacks it, so
/// the gate fails.
enum class Absence { Undefined, NothingInReference, MissingInResult };

/// The interval that must lie within the limits of a gate that is met, where the image is looked at while it
/// gets samples: a gate is not met because noise hides whether it is. `low` and `high` of the metric are then
/// what must lie beyond them in one that is missed.
struct ToPass {
  double low = 0;
  double high = 0;
  double reference_share = 0;  // of its variance, which no samples of the result make less
  double reach_to_fail = 0;    // half of low to high without what looks alone make smaller; 0: all of it
};

struct MetricResult {
  std::optional<double> value;          // +infinity is a number
  image::Image map = {};                // one or three channels; NaN where the definition gives no value
  std::optional<Rectangle> where = {};  // the pixels that the number is of, unless it is of all
  std::optional<double> low = {};       // ends of its interval, where it has one
  std::optional<double> high = {};
  Absence absence = Absence::Undefined;  // where there is no value
  std::string what = {};                 // what the number is of, in words, where its name does not say it
  std::optional<ToPass> to_pass = {};
};

/// The error map that a metric leaves behind.
struct MapInfo {
  std::string_view name;  // also the end of its file name
  std::string_view definition;
  bool is_signed;
  /// Where the colour scale of its PNG ends: fixed, so that images of different renderers can be laid side
  /// by side.
  float scale_maximum;
};

/// Of a metric without an error map.
inline constexpr MapInfo kNoMap{"", "", false, 0.0F};

/// Whether every comparison computes a metric, or only one that asks for it.
enum class Computed { Always, OnDemand };

/// Which values of a metric are good ones.
enum class Better { Lower, Higher, NearZero };

/// What a gate compares with its limits. Value: the number. Certain: likewise, of what is certain of an
/// error, which noise makes no larger. CertainShare: likewise, where the limit is kCertainShare of the error
/// that is promised to be found, and an image that can get more samples passes when it may have no such
/// error. WholeInterval: fails where the whole interval lies beyond a limit, and is inconclusive where only a
/// part does. AnyOfInterval: fails where the whole interval lies beyond, and passes else. NoiseAware: the
/// number, but a miss that noise alone explains is inconclusive.
enum class GateRule { Value, Certain, CertainShare, WholeInterval, AnyOfInterval, NoiseAware };

/// What a gate allows; nothing: no limit on that side.
struct Limits {
  std::optional<double> min;
  std::optional<double> max;
};

struct Measurement;

/// One metric: what it is called, what exactly it computes, how. Everything that help texts, results,
/// verdicts and reports say about a metric comes from here.
struct MetricInfo {
  std::string_view name;
  std::string_view unit;
  Better better;
  std::string_view definition;
  MapInfo map;
  MetricResult (*compute)(const ImagePair&);
  Computed computed = Computed::Always;
  GateRule rule = GateRule::Value;
  /// How a verdict states the number beside what its gate allows; nullptr: "<name> is <value> <unit>".
  std::string (*describe)(const Measurement&, const Limits&) = nullptr;
};

/// The number of one metric for one pair of images.
struct Measurement {
  const MetricInfo* metric;
  std::optional<double> value;  // +infinity for the PSNR of equal images
  std::optional<Rectangle> where = {};
  std::optional<double> low = {};
  std::optional<double> high = {};
  Absence absence = Absence::Undefined;
  std::string what = {};
  std::optional<ToPass> to_pass = {};
};

/// Mean of error(result sample, reference sample) over the three channels of the included pixels, and the
/// same errors as a map of all pixels. The mean is summed in double by rows from the top, independent of
/// threads.
template <typename Error>
MetricResult mean_error(const ImagePair& pair,
                        const std::vector<float>& result,
                        const std::vector<float>& reference,
                        Error error) {
  image::Image map = image::make_image(pair.width, pair.height, {"R", "G", "B"});
  double sum = 0.0;
  for (std::size_t pixel = 0; pixel < pair.pixel_count(); ++pixel) {
    double sum_of_pixel = 0.0;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      const double e = error(static_cast<double>(result[i]), static_cast<double>(reference[i]));
      map.pixels[i] = static_cast<float>(e);
      sum_of_pixel += e;
    }
    if (pair.included[pixel] != 0) sum += sum_of_pixel;
  }
  return {sum / (3.0 * static_cast<double>(pair.included_count)), std::move(map)};
}

}  // namespace orbs::metrics
