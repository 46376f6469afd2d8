#include "metrics/seeds.h"

#include "base/error.h"
#include "base/text.h"
#include "image/layers.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace orbs::metrics {

namespace {

double mean_at(const std::vector<image::Image>& colours, std::size_t sample) {
  double sum = 0;
  for (const auto& colour : colours) sum += static_cast<double>(colour.pixels[sample]);
  return sum / static_cast<double>(colours.size());
}

void check_seeds(const std::vector<image::Image>& colours) {
  if (colours.size() < 2)
    throw InputError(
        fmt::format("the noise of {} render cannot be known; two seeds are needed", colours.size()));
  const auto& first = colours.front();
  for (const auto& colour : colours)
    if (colour.width != first.width || colour.height != first.height)
      throw InputError(fmt::format("renders of one scene differ in size: {} x {} px and {} x {} px",
                                   first.width, first.height, colour.width, colour.height));
  if (are_equal(colours)) throw InputError(std::string(kEqualSeeds));
}

}  // namespace

std::map<std::string, std::string> with_sample_counts(std::map<std::string, std::string> attributes,
                                                      const std::vector<image::Image>& images) {
  std::vector<const char*> names(kCounters.begin(), kCounters.end());
  names.push_back("orbs.spp");
  for (const char* name : names) {
    long long sum = 0;
    bool is_known = true;
    for (const auto& image : images) {
      const auto stated = image.attributes.find(name);
      const auto count = stated == image.attributes.end() ? std::nullopt : to_integer(stated->second);
      is_known = is_known && count;
      sum += count.value_or(0);
    }
    attributes.erase(name);
    if (is_known) attributes[name] = std::to_string(sum);
  }
  return attributes;
}

namespace {

// A channel of the mean, and the channel of each render that it is made of.
struct Layer {
  std::string name;
  std::vector<std::size_t> index_in;
  bool holds_variance = false;
};

std::vector<std::size_t> indices_of(const std::vector<image::Image>& images, const std::string& channel) {
  std::vector<std::size_t> indices;
  for (const auto& image : images) {
    const int index = image::channel_index(image, channel);
    if (index < 0)
      throw InputError(
          fmt::format("renders of one scene differ in their channels: '{}' is not in all of them", channel));
    indices.push_back(static_cast<std::size_t>(index));
  }
  return indices;
}

bool is_stokes(std::string_view channel) {
  return channel.starts_with("S1.") || channel.starts_with("S2.") || channel.starts_with("S3.");
}

// R, G, B and their variances first, then all other channels in the order of the first render. Variances
// that the renders state are left out: the scatter tells.
std::vector<Layer> layers_of(const std::vector<image::Image>& images) {
  constexpr std::array kColours{"R", "G", "B"};
  std::vector<Layer> layers;
  const auto add = [&](const std::string& channel, bool holds_variance) {
    layers.push_back(
        {(holds_variance ? "variance." : "") + channel, indices_of(images, channel), holds_variance});
  };
  for (const bool holds_variance : {false, true})
    for (const auto* colour : kColours) add(colour, holds_variance);
  const auto is_left = [&](const std::string& channel) {
    return !image::is_variance(channel) &&
           std::find(kColours.begin(), kColours.end(), channel) == kColours.end();
  };
  for (const auto& image : images)
    for (const auto& channel : image.channels)
      if (is_left(channel)) indices_of(images, channel);  // refuses what is not in all
  for (const auto& channel : images.front().channels)
    if (is_left(channel)) add(channel, false);
  for (const auto& channel : images.front().channels)
    if (is_stokes(channel)) add(channel, true);
  return layers;
}

}  // namespace

bool are_equal(const std::vector<image::Image>& images) {
  return std::all_of(images.begin(), images.end(),
                     [&](const auto& image) { return image::has_same_colours(image, images.front()); });
}

image::Image mean_of(const std::vector<image::Image>& images) {
  const auto colours = image::colours_of(images);
  auto mean = image::make_image(colours.front().width, colours.front().height, {"R", "G", "B"});
  for (std::size_t i = 0; i < mean.pixels.size(); ++i)
    mean.pixels[i] = static_cast<float>(mean_at(colours, i));
  return mean;
}

image::Image mean_and_variance_of(const std::vector<image::Image>& images) {
  check_seeds(image::colours_of(images));
  const auto layers = layers_of(images);
  std::vector<std::string> channels;
  for (const auto& layer : layers) channels.push_back(layer.name);
  auto out = image::make_image(images.front().width, images.front().height, std::move(channels));
  out.attributes = with_sample_counts(images.front().attributes, images);
  const auto count = static_cast<double>(images.size());
  for (std::size_t pixel = 0; pixel < out.pixel_count(); ++pixel)
    for (std::size_t i = 0; i < layers.size(); ++i) {
      const auto value_in = [&](std::size_t k) {
        return static_cast<double>(
            images[k].pixels[pixel * images[k].channel_count() + layers[i].index_in[k]]);
      };
      if (image::is_layer_channel(layers[i].name)) {
        out.pixels[pixel * layers.size() + i] = static_cast<float>(value_in(0));
        continue;
      }
      double mean = 0;
      for (std::size_t k = 0; k < images.size(); ++k) mean += value_in(k);
      mean /= count;
      double squares = 0;
      for (std::size_t k = 0; k < images.size(); ++k) squares += (value_in(k) - mean) * (value_in(k) - mean);
      out.pixels[pixel * layers.size() + i] =
          static_cast<float>(layers[i].holds_variance ? squares / (count - 1) / count : mean);
    }
  return out;
}

}  // namespace orbs::metrics
