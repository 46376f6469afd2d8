#include "metrics/surface_layers.h"

#include "base/statistics.h"
#include "metrics/coverage_edges.h"
#include "metrics/describe.h"
#include "metrics/image_pair.h"
#include "metrics/layer_faults.h"
#include "metrics/layer_samples.h"
#include "metrics/layer_values.h"
#include "metrics/layer_windows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::metrics {

namespace {

using image::LayerKind;

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

// By how much the value lies beyond the range; infinity for what is no number.
double beyond(double value, LayerRange range, double size) {
  if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
  const double tolerance =
      kHalfStep * std::max(std::fabs(range.least), std::fabs(range.most)) + kLayerRounding * size;
  return std::max({0.0, value - range.most - tolerance, range.least - value - tolerance});
}

void find_in_mean(const ImagePair& pair, const ComparedLayer& of, PixelFindings& found) {
  const auto& layers = *pair.layers;
  const double size = layer_size(pair, of);
  for (const auto& channel : of.channels)
    for (std::size_t i = 0; i < pair.pixel_count(); ++i) {
      if (pair.included[i] == 0 || layers.coverage[i] < 1) continue;
      const double value = static_cast<double>(channel.result[i]);
      const auto range = range_beside(pair, channel, i);
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
    LayerRange range;
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

// The largest difference of the coverage's means over 8 x 8 px, less the reach of one sample a pixel.
LayerWindow worst_coverage_block(const ImagePair& pair, const LayerChannel& channel, double quantile) {
  LayerWindow worst;
  for (const auto& block : blocks_of(pair)) {
    double difference = 0;
    double variance = 0;
    double count = 0;
    for_each_block_pixel(pair, block, [&](std::size_t i) {
      const double covered = static_cast<double>(channel.reference[i]);
      difference += static_cast<double>(channel.result[i]) - covered;
      variance += covered * (1 - covered);
      ++count;
    });
    const double left = std::isfinite(difference) ? std::fabs(difference) - quantile * std::sqrt(variance)
                                                  : std::numeric_limits<double>::infinity();
    if (count == 0 || !(left / count > worst.certain)) continue;
    worst = {block,
             fmt::format("the mean of {} over 8 x 8 px is off by {:.3g}", channel.name,
                         std::fabs(difference) / count),
             left / count};
  }
  return worst;
}

LayerWindow worst_of_coverage(const ImagePair& pair, const LayerChannel& channel, double false_alarms) {
  constexpr double kNormal = 1e9;  // degrees of freedom
  auto worst = worst_coverage_block(pair, channel, student_quantile(false_alarms, kNormal));
  const auto edges = coverage_edges(pair, channel, false_alarms);
  if (!(edges.certain > worst.certain)) return worst;
  const double samples = 1 / edges.error;
  return {{0, 0, pair.width, pair.height},
          fmt::format("{} is off at edges as one of {:.2g} samples a pixel is, or one whose edges are moved",
                      channel.name, samples),
          edges.certain};
}

double tests_of(const ImagePair& pair, const ComparedLayer& of) {
  if (of.layer->kind == LayerKind::Id) return 0;
  if (of.layer->kind == LayerKind::Mean) return window_tests(pair, of);
  return static_cast<double>(blocks_of(pair).size()) + 1;
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
  constexpr double kFalseAlarm = 1e-4;
  double tests = 0;
  for (const auto& of : pair.layers->layers) tests += tests_of(pair, of);
  const double of_one = kFalseAlarm / std::max(1.0, pair.looks * tests);
  MetricResult result{.value = 0.0};
  for (const auto& of : pair.layers->layers) {
    if (of.layer->kind == LayerKind::Id) continue;
    const auto worst = of.layer->kind == LayerKind::Mean
                           ? worst_window(pair, of, of_one)
                           : worst_of_coverage(pair, of.channels.front(), of_one);
    if (!(worst.certain > *result.value)) continue;
    result.value = worst.certain;
    result.where = worst.where;
    result.what = fault_text(pair, &of) + worst.what;
  }
  return result;
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
  return fmt::format("{}, by {:.3g} % or more for certain, {}", measurement.what,
                     kPercent * *measurement.value, limits_text(limits, kPercent, " %"));
}

}  // namespace orbs::metrics
