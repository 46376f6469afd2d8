#include "metrics/layer_samples.h"

#include "base/text.h"

#include <algorithm>
#include <utility>

namespace orbs::metrics {

namespace {

// Empty if the image has no channel of that name.
std::vector<float> plane_of(const image::Image& image, const std::string& channel) {
  const int index = image::channel_index(image, channel);
  std::vector<float> plane;
  if (index < 0) return plane;
  plane.reserve(image.pixel_count());
  for (std::size_t i = static_cast<std::size_t>(index); i < image.pixels.size(); i += image.channel_count())
    plane.push_back(image.pixels[i]);
  return plane;
}

bool holds(const image::Image& image, const image::LayerInfo& layer) {
  const auto channels = image::channels_of(layer);
  return std::all_of(channels.begin(), channels.end(),
                     [&](const auto& channel) { return image::channel_index(image, channel) >= 0; });
}

bool is_asked_for(const image::Image& reference, const image::LayerInfo& layer) {
  const auto stated = reference.attributes.find("orbs.layers");
  if (stated == reference.attributes.end()) return true;
  const auto names = split(stated->second, ' ');
  return std::find(names.begin(), names.end(), layer.name) != names.end();
}

LayerChannel channel_of(const image::Image& result, const image::Image& reference, const std::string& name) {
  LayerChannel channel{.name = name,
                       .result = plane_of(result, name),
                       .reference = plane_of(reference, name),
                       .least = plane_of(reference, std::string(image::kLeast) + name),
                       .most = plane_of(reference, std::string(image::kMost) + name)};
  if (channel.least.empty() || channel.most.empty()) channel.least = channel.most = channel.reference;
  return channel;
}

}  // namespace

std::optional<LayerSamples> layer_samples(const image::Image& result, const image::Image& reference) {
  LayerSamples samples;
  for (const auto& layer : image::kLayers) {
    if (!holds(reference, layer) || !is_asked_for(reference, layer)) continue;
    if (!holds(result, layer)) {
      samples.missing.emplace_back(layer.name);
      continue;
    }
    ComparedLayer both{&layer, {}};
    for (const auto& name : image::channels_of(layer))
      both.channels.push_back(channel_of(result, reference, name));
    samples.layers.push_back(std::move(both));
  }
  if (samples.layers.empty() && samples.missing.empty()) return std::nullopt;
  samples.coverage = plane_of(reference, "coverage.A");
  if (samples.coverage.empty()) samples.coverage.assign(reference.pixel_count(), 1.0F);
  return samples;
}

}  // namespace orbs::metrics
