#include "cli/compare/chosen_channels.h"

#include "base/error.h"
#include "image/layers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

namespace {

// Channels that can be red, green and blue of an image; of grey three times the same.
struct Colours {
  std::string name;  // of the layer or of the grey channel; "" for R, G and B
  std::array<std::size_t, 3> channels{};
};

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// The channel of the layer that is called one of two names, in any case.
std::optional<std::size_t> part_of(const image::Image& image,
                                   const std::string& layer,
                                   const std::array<const char*, 2>& names) {
  for (std::size_t i = 0; i < image.channel_count(); ++i) {
    const auto& channel = image.channels[i];
    if (!channel.starts_with(layer)) continue;
    const auto part = lower_case(channel.substr(layer.size()));
    if (part == names[0] || part == names[1]) return i;
  }
  return std::nullopt;
}

// `layer` with its dot.
std::optional<Colours> colours_of_layer(const image::Image& image, const std::string& layer) {
  const auto red = part_of(image, layer, {"r", "red"});
  const auto green = part_of(image, layer, {"g", "green"});
  const auto blue = part_of(image, layer, {"b", "blue"});
  if (!red || !green || !blue) return std::nullopt;
  return Colours{layer.substr(0, layer.size() - (layer.empty() ? 0 : 1)), {*red, *green, *blue}};
}

// Variances, what the camera sees first, and what polarisation has are no images of light.
bool is_of_light(const std::string& channel) {
  return !image::is_variance(channel) && !image::is_layer_channel(channel) && !channel.starts_with("S1.") &&
         !channel.starts_with("S2.") && !channel.starts_with("S3.");
}

std::vector<Colours> colours_in(const image::Image& image) {
  std::vector<Colours> found;
  for (const auto& channel : image.channels) {
    const auto layer = channel.substr(0, channel.rfind('.') + 1);
    if (!is_of_light(channel)) continue;
    const auto colours = colours_of_layer(image, layer);
    if (colours && std::none_of(found.begin(), found.end(),
                                [&](const Colours& one) { return one.name == colours->name; }))
      found.push_back(*colours);
  }
  return found;
}

std::optional<Colours> grey_of(const image::Image& image, const std::string& channel) {
  const int index = image::channel_index(image, channel);
  if (index < 0) return std::nullopt;
  const auto at = static_cast<std::size_t>(index);
  return Colours{channel, {at, at, at}};
}

// Of an image that has one channel beside alpha.
std::optional<Colours> only_grey(const image::Image& image) {
  std::vector<std::string> names;
  for (const auto& channel : image.channels)
    if (channel != "A" && is_of_light(channel)) names.push_back(channel);
  return names.size() == 1 ? grey_of(image, names.front()) : std::nullopt;
}

// What programs call the layer of all light.
bool is_whole(const Colours& colours) {
  const auto name = lower_case(colours.name.substr(colours.name.rfind('.') + 1));
  return name == "combined" || name == "rgba" || name == "rgb" || name == "beauty" || name == "color";
}

template <typename Wanted>
std::optional<Colours> only_one(const std::vector<Colours>& all, const Wanted& is_wanted) {
  const auto first = std::find_if(all.begin(), all.end(), is_wanted);
  if (first == all.end() || std::find_if(first + 1, all.end(), is_wanted) != all.end()) return std::nullopt;
  return *first;
}

std::optional<Colours> colours_without_word(const image::Image& image, const image::Image& other) {
  const auto all = colours_in(image);
  const auto any = [](const Colours&) { return true; };
  const auto plain = [](const Colours& one) { return one.name.empty(); };
  const auto in_other = colours_in(other);
  const auto shared = [&](const Colours& one) {
    return std::any_of(in_other.begin(), in_other.end(),
                       [&](const Colours& theirs) { return theirs.name == one.name; });
  };
  for (const auto& found :
       {only_one(all, plain), only_one(all, any), only_one(all, shared), only_one(all, is_whole)})
    if (found) return found;
  return all.empty() ? only_grey(image) : std::nullopt;
}

// These first, as R, G and B, and then all others but what has one of these names.
image::Image with_colours(const image::Image& image, const std::array<std::size_t, 3>& colours) {
  std::vector<std::size_t> taken(colours.begin(), colours.end());
  std::vector<std::string> channels{"R", "G", "B"};
  for (std::size_t i = 0; i < image.channel_count(); ++i) {
    const bool is_free = std::find(channels.begin(), channels.end(), image.channels[i]) == channels.end();
    if (!is_free || std::find(colours.begin(), colours.end(), i) != colours.end()) continue;
    taken.push_back(i);
    channels.push_back(image.channels[i]);
  }
  auto renamed = image::make_image(image.width, image.height, channels);
  for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel)
    for (std::size_t i = 0; i < taken.size(); ++i)
      renamed.pixels[pixel * taken.size() + i] = image.pixels[pixel * image.channel_count() + taken[i]];
  renamed.attributes = image.attributes;
  return renamed;
}

}  // namespace

std::string choose_channels(image::Image& image,
                            const image::Image& other,
                            const std::string& wanted,
                            const std::string& file) {
  std::optional<Colours> chosen;
  if (!wanted.empty()) {
    chosen = colours_of_layer(image, wanted + ".");
    if (!chosen) chosen = grey_of(image, wanted);
    const bool has_other = colours_of_layer(other, wanted + ".") || grey_of(other, wanted);
    if (!chosen && !has_other)
      throw InputError(
          fmt::format("{} has no channels '{}'; it has {}; name a layer, as 'Combined' of "
                      "'Combined.R', or a channel",
                      file, wanted, fmt::join(image.channels, ", ")));
  }
  if (!chosen) chosen = colours_without_word(image, other);
  if (!chosen)
    throw InputError(
        fmt::format("{} has the channels {}; --channels NAME says which are its colours: a layer, as "
                    "'Combined' of 'Combined.R', or a channel",
                    file, fmt::join(image.channels, ", ")));
  const std::array<std::string, 3> names{"R", "G", "B"};
  bool is_plain = true;
  for (std::size_t c = 0; c < 3; ++c)
    is_plain = is_plain && image.channels[chosen->channels.at(c)] == names.at(c);
  if (is_plain) return "";
  image = with_colours(image, chosen->channels);
  return fmt::format("of {} the channels of '{}' are compared", file, chosen->name);
}

}  // namespace orbs::cli
