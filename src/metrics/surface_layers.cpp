#include "metrics/surface_layers.h"

#include "base/statistics.h"
#include "metrics/describe.h"
#include "metrics/image_pair.h"
#include "metrics/layer_faults.h"
#include "metrics/layer_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::metrics {

namespace {

using image::LayerKind;

constexpr double kHalfStep = 1.0 / 1024;  // of a half float, relative to its value
// A few roundings of single precision, relative to the largest value of the layer: a zero among the parts of
// a unit vector or of a position is seldom one to the last digit.
constexpr double kRounding = 0x1p-20;

// Calls visit(neighbour) for the pixel and those beside it.
template <typename Visit>
void for_each_neighbour(const PairSamples& samples, std::size_t pixel, Visit visit) {
  const int width = samples.width;
  const int x = static_cast<int>(pixel) % width;
  const int y = static_cast<int>(pixel) / width;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, samples.height - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) visit(samples.pixel_at(u, v));
}

// The largest value of the layer in the reference, where a surface is; 1 for a coverage, and of zeros.
double size_of(const ComparedLayer& of, const LayerSamples& layers) {
  if (of.layer->kind != LayerKind::Mean) return 1;
  double size = 0;
  for (const auto& channel : of.channels)
    for (std::size_t i = 0; i < channel.reference.size(); ++i)
      if (layers.coverage[i] > 0) size = std::max(size, static_cast<double>(std::fabs(channel.reference[i])));
  return size > 0 ? size : 1;
}

// What is found wrong in pixels: how far off they are, and the worst in words.
struct PixelFindings {
  image::Image map{};  // one channel; 0: right
  std::size_t worst = 0;
  double worst_by = 0;
  std::string what{};
  const ComparedLayer* layer = nullptr;  // of the worst
};

void note(
    PixelFindings& found, const ComparedLayer& layer, std::size_t pixel, double by, const std::string& what) {
  auto& at = found.map.pixels[pixel];
  at = std::max(at, static_cast<float>(by));
  if (by <= found.worst_by) return;
  found.worst = pixel;
  found.worst_by = by;
  found.what = what;
  found.layer = &layer;
}

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
};

Range range_beside(const PairSamples& samples,
                   const LayerSamples& layers,
                   const LayerChannel& channel,
                   std::size_t pixel) {
  Range range;
  for_each_neighbour(samples, pixel, [&](std::size_t i) {
    if (!(layers.coverage[i] > 0)) return;
    range.least = std::min(range.least, static_cast<double>(channel.least[i]));
    range.most = std::max(range.most, static_cast<double>(channel.most[i]));
  });
  return range;
}

// By how much the value lies beyond the range; infinity for what is no number.
double beyond(double value, Range range, double size) {
  if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
  const double tolerance =
      kHalfStep * std::max(std::fabs(range.least), std::fabs(range.most)) + kRounding * size;
  return std::max({0.0, value - range.most - tolerance, range.least - value - tolerance});
}

void find_in_mean(const ImagePair& pair, const ComparedLayer& of, PixelFindings& found) {
  const auto& layers = *pair.layers;
  const double size = size_of(of, layers);
  for (const auto& channel : of.channels)
    for (std::size_t i = 0; i < pair.pixel_count(); ++i) {
      if (pair.included[i] == 0 || layers.coverage[i] < 1) continue;
      const double value = static_cast<double>(channel.result[i]);
      const auto range = range_beside(pair, layers, channel, i);
      if (const double by = beyond(value, range, size); by > 0)
        note(found, of, i, by / size,
             fmt::format("{} is {:.5g} where the scene has {:.5g} to {:.5g}", channel.name, value,
                         range.least, range.most));
    }
}

void find_in_coverage(const ImagePair& pair, const ComparedLayer& of, PixelFindings& found) {
  const auto& result = of.channels.front().result;
  const auto& coverage = pair.layers->coverage;
  for (std::size_t i = 0; i < pair.pixel_count(); ++i) {
    if (pair.included[i] == 0) continue;
    Range range;
    for_each_neighbour(pair, i, [&](std::size_t k) {
      range.least = std::min(range.least, static_cast<double>(coverage[k]));
      range.most = std::max(range.most, static_cast<double>(coverage[k]));
    });
    const double value = static_cast<double>(result[i]);
    const bool is_uniform = range.least == range.most && (range.most == 0 || range.most == 1);
    if (!is_uniform) range = {0, 1};
    if (const double by = beyond(value, range, 1); by > 0)
      note(found, of, i, by,
           fmt::format("coverage.A is {:.5g} where it should be {:.5g}", value, range.most));
  }
}

// The number that the result most often has for each thing of the reference, away from edges.
std::map<float, float> names_of(const ImagePair& pair, const LayerChannel& channel) {
  std::map<float, std::map<float, int>> counts;
  for (std::size_t i = 0; i < pair.pixel_count(); ++i) {
    bool is_inside = pair.included[i] != 0;
    for_each_neighbour(pair, i, [&](std::size_t k) {
      is_inside = is_inside && channel.reference[k] == channel.reference[i];
    });
    if (is_inside && channel.reference[i] > 0) ++counts[channel.reference[i]][channel.result[i]];
  }
  std::map<float, float> names;
  for (const auto& [thing, numbers] : counts)
    names[thing] = std::max_element(numbers.begin(), numbers.end(), [](const auto& a, const auto& b) {
                     return a.second < b.second;
                   })->first;
  return names;
}

// Things that are too small to have an inside have no name; any number is right where they are.
void find_in_ids(const ImagePair& pair, const ComparedLayer& of, PixelFindings& found) {
  const auto& channel = of.channels.front();
  const auto names = names_of(pair, channel);
  std::map<float, float> owners;  // the first thing of each number
  for (const auto& [thing, number] : names) owners.try_emplace(number, thing);
  for (std::size_t i = 0; i < pair.pixel_count(); ++i) {
    if (pair.included[i] == 0 || pair.layers->coverage[i] < 1) continue;
    bool is_right = false;
    bool is_shared = false;
    for_each_neighbour(pair, i, [&](std::size_t k) {
      const auto name = names.find(channel.reference[k]);
      const bool is_named = name == names.end() || name->second == channel.result[i];
      const bool is_own = name == names.end() || owners.at(name->second) == channel.reference[k];
      is_right = is_right || (is_named && is_own);
      is_shared = is_shared || (is_named && !is_own);
    });
    if (is_right) continue;
    const auto own = names.find(channel.reference[i]);
    note(found, of, i, 1,
         is_shared ? fmt::format("{} is {:.5g}, which is also the number of another thing", channel.name,
                                 channel.result[i])
                   : fmt::format("{} is {:.5g} where the thing has the number {:.5g} elsewhere", channel.name,
                                 channel.result[i], own == names.end() ? 0.0F : own->second));
  }
}

PixelFindings findings(const ImagePair& pair) {
  PixelFindings found{.map = image::make_image(pair.width, pair.height, {"error"})};
  for (const auto& layer : pair.layers->layers) {
    if (layer.layer->kind == LayerKind::Mean) find_in_mean(pair, layer, found);
    if (layer.layer->kind == LayerKind::Coverage) find_in_coverage(pair, layer, found);
    if (layer.layer->kind == LayerKind::Id) find_in_ids(pair, layer, found);
  }
  return found;
}

struct BlockError {
  double off = 0;      // |difference of the means|
  double certain = 0;  // less its reach
};

std::optional<BlockError> block_error(const ImagePair& pair,
                                      const ComparedLayer& of,
                                      const LayerChannel& channel,
                                      const Rectangle& block,
                                      double quantile) {
  const auto& coverage = pair.layers->coverage;
  const bool is_coverage = of.layer->kind == LayerKind::Coverage;
  double difference = 0;
  double variance = 0;
  double count = 0;
  for_each_block_pixel(pair, block, [&](std::size_t i) {
    const double covered = static_cast<double>(coverage[i]);
    if (!is_coverage && covered < 1) return;
    difference += static_cast<double>(channel.result[i]) - static_cast<double>(channel.reference[i]);
    const double range = static_cast<double>(channel.most[i]) - static_cast<double>(channel.least[i]);
    variance += is_coverage ? covered * (1 - covered) : range * range / 4;
    ++count;
  });
  if (count == 0) return std::nullopt;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!std::isfinite(difference)) return BlockError{kInfinity, kInfinity};
  const double off = std::fabs(difference) / count;
  return BlockError{off, std::max(0.0, off - quantile * std::sqrt(variance) / count)};
}

// "the layer 'depth' is along the ray and not along the axis: ", or nothing.
std::string fault_text(const ImagePair& pair, const ComparedLayer* layer) {
  if (layer == nullptr) return "";
  const auto fault = layer_fault(pair, *layer);
  return fault.empty() ? "" : fmt::format("the layer '{}' is {}: ", layer->layer->name, fault);
}

MetricResult nothing_or_missing(const ImagePair& pair) {
  if (!pair.layers) return {.value = std::nullopt, .absence = Absence::NothingInReference};
  return {.value = std::nullopt,
          .absence = Absence::MissingInResult,
          .what = fmt::format("{}", fmt::join(pair.layers->missing, ", "))};
}

std::string absence_text(const Measurement& measurement) {
  return measurement.absence == Absence::NothingInReference
             ? "the reference has no layers of surfaces to be compared with"
             : fmt::format("it lacks layers that the scene asks for: {}", measurement.what);
}

}  // namespace

MetricResult compute_layer_pixels(const ImagePair& pair) {
  if (!pair.layers || !pair.layers->missing.empty()) return nothing_or_missing(pair);
  auto found = findings(pair);
  const auto off =
      std::count_if(found.map.pixels.begin(), found.map.pixels.end(), [](float by) { return by > 0; });
  MetricResult result{.value = static_cast<double>(off), .map = std::move(found.map)};
  if (off == 0) return result;
  const int x = static_cast<int>(found.worst) % pair.width;
  const int y = static_cast<int>(found.worst) / pair.width;
  result.where = Rectangle{x, y, x + 1, y + 1};
  result.what = fmt::format("{}at ({}, {}), {}", fault_text(pair, found.layer), x, y, found.what);
  return result;
}

MetricResult compute_layer_error(const ImagePair& pair) {
  if (!pair.layers || !pair.layers->missing.empty()) return nothing_or_missing(pair);
  constexpr double kNormal = 1e9;  // degrees of freedom
  constexpr double kFalseAlarm = 1e-4;
  const auto blocks = blocks_of(pair);
  double tests = static_cast<double>(pair.looks);
  double channels = 0;
  for (const auto& of : pair.layers->layers) channels += static_cast<double>(of.channels.size());
  tests *= std::max(1.0, channels * static_cast<double>(blocks.size()));
  const double quantile = student_quantile(kFalseAlarm / 2 / tests, kNormal);
  MetricResult worst{.value = 0.0};
  const ComparedLayer* layer = nullptr;
  for (const auto& of : pair.layers->layers) {
    if (of.layer->kind == LayerKind::Id) continue;
    const double size = size_of(of, *pair.layers);
    for (const auto& channel : of.channels)
      for (const auto& block : blocks) {
        const auto error = block_error(pair, of, channel, block, quantile);
        if (!error || !(error->certain / size > *worst.value)) continue;
        worst.value = error->certain / size;
        worst.where = block;
        layer = &of;
        worst.what = fmt::format("the mean of {} over 8 x 8 px is off by {:.3g}", channel.name, error->off);
      }
  }
  worst.what = fault_text(pair, layer) + worst.what;
  return worst;
}

std::string describe_layer_pixels(const Measurement& measurement, const Limits& limits) {
  if (!measurement.value) return absence_text(measurement);
  if (*measurement.value == 0) return "all its layers of surfaces lie within what the pixels show";
  return fmt::format("{}; so in {:.0f} px, {}", measurement.what, *measurement.value,
                     limits_text(limits, 1, " px"));
}

std::string describe_layer_error(const Measurement& measurement, const Limits& limits) {
  if (!measurement.value) return absence_text(measurement);
  if (*measurement.value == 0) return "no mean of its layers of surfaces is off for certain";
  constexpr double kPercent = 100;
  return fmt::format("{}, {:.3g} % of the layer's largest value or more for certain, {}", measurement.what,
                     kPercent * *measurement.value, limits_text(limits, kPercent, " %"));
}

}  // namespace orbs::metrics
