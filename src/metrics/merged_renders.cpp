#include "metrics/merged_renders.h"

#include "base/error.h"
#include "image/layers.h"
#include "metrics/seeds.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace orbs::metrics {

namespace {

constexpr std::array kHalves{"first.", "second."};
constexpr const char* kStated = "orbs.states_variance";

bool has_variance(const image::Image& image) { return image::channel_index(image, "variance.R") >= 0; }

void refuse_other(const image::Image& merged, const image::Image& render) {
  if (merged.width != render.width || merged.height != render.height)
    throw InputError(fmt::format("renders of one scene differ in size: {} x {} px and {} x {} px",
                                 merged.width, merged.height, render.width, render.height));
}

std::size_t index_in(const image::Image& render, const std::string& channel) {
  const int index = image::channel_index(render, channel);
  if (index < 0)
    throw InputError(
        fmt::format("renders of one scene differ in their channels: '{}' is not in all of them", channel));
  return static_cast<std::size_t>(index);
}

// A channel of the merged image, that of the render with its values, and where the merged variance of its own
// values lies: only for a variance that is told by scatter.
struct Channel {
  std::size_t own = 0;
  std::size_t in_render = 0;
  bool is_variance = false;
  bool is_of_first = false;  // the layers of surfaces stay those of the first render
};

std::vector<Channel> channels_of(const MergedRenders& merged, const image::Image& render) {
  constexpr std::size_t kPrefix = 9;  // of "variance."
  std::vector<Channel> channels;
  for (std::size_t c = 0; c < merged.mean.channel_count(); ++c) {
    const auto& name = merged.mean.channels[c];
    const bool is_variance = image::is_variance(name);
    const bool is_by_scatter = is_variance && !merged.states_variance;
    channels.push_back({c, index_in(render, is_by_scatter ? name.substr(kPrefix) : name), is_variance,
                        image::is_layer_channel(name)});
  }
  return channels;
}

// By how many samples and renders one more of `samples` is added.
struct Weights {
  double before = 0;
  double added = 0;
  double renders = 0;  // before
  double all() const { return before + added; }
};

double with_stated_variance(double merged, double own, const Weights& n) {
  return (n.before * n.before * merged + n.added * n.added * own) / (n.all() * n.all());
}

// M2 grows by d^2 n n_i / (n + n_i), where d is the step from the mean to the render.
double with_scatter(double merged, double step, const Weights& n) {
  const double squares = merged * (n.renders - 1) * n.before + step * step * n.before * n.added / n.all();
  return squares / (n.renders * n.all());
}

// Variances first, as they need the mean before the render.
void add_render(MergedRenders& merged, const image::Image& render, int spp) {
  refuse_other(merged.mean, render);
  const Weights n{static_cast<double>(merged.samples), static_cast<double>(spp),
                  static_cast<double>(merged.renders)};
  auto& mean = merged.mean;
  const auto channels = channels_of(merged, render);
  const auto next = [&](std::size_t pixel, const Channel& channel) {
    const double before = static_cast<double>(mean.pixels[pixel * mean.channel_count() + channel.own]);
    if (channel.is_of_first) return before;
    const double value =
        static_cast<double>(render.pixels[pixel * render.channel_count() + channel.in_render]);
    if (!channel.is_variance) return before + (value - before) * n.added / n.all();
    if (merged.states_variance) return with_stated_variance(before, value, n);
    const auto of_colour = index_in(mean, render.channels[channel.in_render]);
    const double colour = static_cast<double>(mean.pixels[pixel * mean.channel_count() + of_colour]);
    return with_scatter(before, value - colour, n);
  };
  std::vector<double> values(channels.size());
  for (std::size_t pixel = 0; pixel < mean.pixel_count(); ++pixel) {
    for (std::size_t i = 0; i < channels.size(); ++i) values[i] = next(pixel, channels[i]);
    for (std::size_t i = 0; i < channels.size(); ++i)
      mean.pixels[pixel * mean.channel_count() + channels[i].own] = static_cast<float>(values[i]);
  }
  mean.attributes = with_sample_counts(mean.attributes, {mean, render});
  merged.samples += spp;
  ++merged.renders;
}

void add_to_half(image::Image& half, int samples, const image::Image& render, int spp) {
  const auto colours = image::select_rgb(render, "");
  if (samples == 0) {
    half = colours;
    return;
  }
  const double share = static_cast<double>(spp) / (static_cast<double>(samples) + spp);
  for (std::size_t i = 0; i < half.pixels.size(); ++i) {
    const double before = static_cast<double>(half.pixels[i]);
    half.pixels[i] = static_cast<float>(before + (static_cast<double>(colours.pixels[i]) - before) * share);
  }
}

}  // namespace

void add_renders(MergedRenders& merged, const std::array<image::Image, 2>& two, int spp) {
  const int samples_of_a_half = merged.samples / 2;
  if (merged.renders == 0) {
    refuse_other(two[0], two[1]);
    if (are_equal({two[0], two[1]})) throw InputError("renders with different seeds are equal to the bit");
    merged.states_variance = has_variance(two[0]) && has_variance(two[1]);
    if (merged.states_variance) {
      merged.mean = two[0];
      merged.samples = spp;
      merged.renders = 1;
      add_render(merged, two[1], spp);
    } else {
      merged.mean = mean_and_variance_of({two[0], two[1]});
      merged.samples = 2 * spp;
      merged.renders = 2;
    }
  } else {
    for (const auto& render : two) add_render(merged, render, spp);
  }
  for (std::size_t half = 0; half < 2; ++half)
    add_to_half(merged.halves.at(half), samples_of_a_half, two.at(half), spp);
}

image::Image halves_image(const MergedRenders& merged) {
  std::vector<std::string> names;
  for (const auto* half : kHalves)
    for (const auto* colour : {"R", "G", "B"}) names.push_back(std::string(half) + colour);
  auto image = image::make_image(merged.mean.width, merged.mean.height, names);
  image.attributes[kStated] = merged.states_variance ? "yes" : "no";
  for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel)
    for (std::size_t half = 0; half < 2; ++half)
      for (std::size_t c = 0; c < 3; ++c)
        image.pixels[6 * pixel + 3 * half + c] = merged.halves.at(half).pixels[3 * pixel + c];
  return image;
}

std::array<image::Image, 2> halves_of(const image::Image& halves) {
  return {image::select_rgb(halves, kHalves[0]), image::select_rgb(halves, kHalves[1])};
}

MergedRenders merged_renders_of(image::Image mean, const image::Image& halves, int renders, int samples) {
  refuse_other(mean, halves);
  MergedRenders merged{.mean = std::move(mean), .halves = {}, .renders = renders, .samples = samples};
  const auto stated = halves.attributes.find(kStated);
  merged.states_variance = stated != halves.attributes.end() && stated->second == "yes";
  merged.halves = halves_of(halves);
  return merged;
}

}  // namespace orbs::metrics
