#include "image/layers.h"

#include <algorithm>

namespace orbs::image {

namespace {

// Without the prefix of a range.
std::string_view value_channel(std::string_view channel) {
  for (const auto prefix : {kLeast, kMost})
    if (channel.starts_with(prefix)) return channel.substr(prefix.size());
  return channel;
}

const LayerInfo* layer_of(std::string_view channel) {
  const auto value = value_channel(channel);
  const auto point = value.find('.');
  if (point == std::string_view::npos) return nullptr;
  const auto* layer = find_layer(value.substr(0, point));
  if (layer == nullptr) return nullptr;
  const auto part = value.substr(point + 1);
  const bool is_part = std::find(layer->parts.begin(), layer->parts.end(), part) != layer->parts.end();
  return is_part && !part.empty() ? layer : nullptr;
}

}  // namespace

bool is_variance(std::string_view channel) { return channel.starts_with("variance."); }

const LayerInfo* find_layer(std::string_view name) {
  const auto* const found = std::find_if(kLayers.begin(), kLayers.end(),
                                         [&](const LayerInfo& layer) { return layer.name == name; });
  return found == kLayers.end() ? nullptr : found;
}

std::vector<std::string> channels_of(const LayerInfo& layer) {
  std::vector<std::string> channels;
  for (const auto part : layer.parts)
    if (!part.empty()) channels.push_back(std::string(layer.name) + "." + std::string(part));
  return channels;
}

Combination combination_of(std::string_view channel) {
  if (is_variance(channel)) return Combination::VarianceOfMean;
  const auto* const layer = layer_of(channel);
  if (layer == nullptr || layer->kind == LayerKind::Coverage) return Combination::Mean;
  if (layer->kind == LayerKind::Id) return Combination::First;
  if (channel.starts_with(kLeast)) return Combination::Least;
  if (channel.starts_with(kMost)) return Combination::Most;
  return Combination::CoveredMean;
}

bool is_range(std::string_view channel) { return channel.starts_with(kLeast) || channel.starts_with(kMost); }

bool is_layer_channel(std::string_view channel) { return layer_of(channel) != nullptr; }

bool stays_float(std::string_view channel) { return is_variance(channel) || is_layer_channel(channel); }

}  // namespace orbs::image
