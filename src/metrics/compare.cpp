#include "metrics/compare.h"

#include "metrics/describe.h"
#include "metrics/table.h"

#include <algorithm>
#include <string>
#include <utility>

namespace orbs::metrics {

namespace {

constexpr MapInfo kSignedMap{"signed", "result - reference in each channel; linear Rec.709, no clamp", true,
                             0.2F};

image::Image signed_difference(const ImagePair& pair) {
  image::Image map = image::make_image(pair.width, pair.height, {"R", "G", "B"});
  for (std::size_t i = 0; i < map.pixels.size(); ++i) map.pixels[i] = pair.result[i] - pair.reference[i];
  return map;
}

bool has_map(const Comparison& comparison, std::string_view name) {
  return std::any_of(comparison.maps.begin(), comparison.maps.end(),
                     [&](const ErrorMap& map) { return map.info.name == name; });
}

bool is_wanted(const MetricInfo& metric, const MetricSelection& selection) {
  return (metric.computed == Computed::Always && !selection.no_others) || selection.all ||
         std::any_of(selection.also.begin(), selection.also.end(),
                     [&](const std::string& name) { return metric.name == name; });
}

}  // namespace

Comparison compare(const ImagePair& pair, const MetricSelection& selection) {
  Comparison comparison;
  for (const std::string& name : selection.also) find_metric(name);
  comparison.pixels_counted = pair.included_count;
  for (const MetricInfo& metric : kMetrics) {
    if (!is_wanted(metric, selection)) continue;
    MetricResult computed = metric.compute(pair);
    comparison.measurements.push_back({&metric, computed.value, computed.where, computed.low, computed.high,
                                       computed.absence, computed.what, computed.to_pass});
    if (!metric.map.name.empty() && !computed.map.pixels.empty() && !has_map(comparison, metric.map.name))
      comparison.maps.push_back({metric.map, std::move(computed.map)});
  }
  comparison.bias_remarks = bias_remarks(pair.noise);
  comparison.maps.push_back({kSignedMap, signed_difference(pair)});
  return comparison;
}

Comparison compare(const image::Image& result,
                   const image::Image& reference,
                   const Mask& mask,
                   const CompareSettings& settings) {
  auto alignment = check_alignment(result, reference, settings.negatives);
  Comparison comparison;
  if (alignment.alignment == Alignment::Comparable)
    comparison = compare(make_image_pair(result, reference, mask, {settings.threads}),
                         {settings.all, settings.no_others, settings.also});
  comparison.alignment = std::move(alignment);
  return comparison;
}

const Measurement* find_measurement(const Comparison& comparison, std::string_view metric) {
  const MetricInfo& wanted = find_metric(metric);
  for (const Measurement& measurement : comparison.measurements)
    if (measurement.metric->name == wanted.name) return &measurement;
  return nullptr;
}

std::optional<double> value_of(const Comparison& comparison, std::string_view metric) {
  const Measurement* const measurement = find_measurement(comparison, metric);
  return measurement == nullptr ? std::nullopt : measurement->value;
}

}  // namespace orbs::metrics
