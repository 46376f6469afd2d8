#include "metrics/compare.h"

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

bool is_wanted(const MetricInfo& metric, const CompareSettings& settings) {
  return (metric.computed == Computed::Always && !settings.no_others) || settings.all ||
         std::any_of(settings.also.begin(), settings.also.end(),
                     [&](const std::string& name) { return metric.name == name; });
}

}  // namespace

Comparison compare(const image::Image& result,
                   const image::Image& reference,
                   const Mask& mask,
                   const CompareSettings& settings) {
  Comparison comparison;
  for (const std::string& name : settings.also) find_metric(name);
  comparison.alignment = check_alignment(result, reference, settings.negatives);
  if (comparison.alignment.alignment != Alignment::Comparable) return comparison;
  const ImagePair pair = make_image_pair(result, reference, mask, settings.threads);
  comparison.pixels_counted = pair.included_count;
  for (const MetricInfo& metric : kMetrics) {
    if (!is_wanted(metric, settings)) continue;
    MetricResult computed = metric.compute(pair);
    comparison.measurements.push_back({&metric, computed.value, computed.where});
    if (!metric.map.name.empty() && !has_map(comparison, metric.map.name))
      comparison.maps.push_back({metric.map, std::move(computed.map)});
  }
  comparison.maps.push_back({kSignedMap, signed_difference(pair)});
  return comparison;
}

std::optional<double> value_of(const Comparison& comparison, std::string_view metric) {
  const MetricInfo& wanted = find_metric(metric);
  for (const Measurement& measurement : comparison.measurements)
    if (measurement.metric->name == wanted.name) return measurement.value;
  return std::nullopt;
}

}  // namespace orbs::metrics
