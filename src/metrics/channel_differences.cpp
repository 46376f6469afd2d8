#include "metrics/channel_differences.h"

#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace orbs::metrics {

namespace {

bool is_of_metrics(std::string_view channel) {
  if (image::is_variance(channel)) channel.remove_prefix(std::string_view("variance.").size());
  return channel == "R" || channel == "G" || channel == "B";
}

double distance(float a, float b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  const double off = std::fabs(static_cast<double>(a) - static_cast<double>(b));
  return std::isfinite(off) ? off : std::numeric_limits<double>::infinity();
}

ChannelDifference difference_of(const image::Image& result,
                                const image::Image& reference,
                                std::size_t channel,
                                std::size_t of_reference) {
  ChannelDifference out{.name = result.channels[channel]};
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) {
      const float a = result.at(x, y, channel);
      const float b = reference.at(x, y, of_reference);
      out.result_mean += static_cast<double>(a);
      out.reference_mean += static_cast<double>(b);
      const double off = distance(a, b);
      if (off > 0) ++out.pixels;
      if (!(off > out.largest)) continue;
      out.largest = off;
      out.x = x;
      out.y = y;
    }
  out.result_mean /= static_cast<double>(result.pixel_count());
  out.reference_mean /= static_cast<double>(result.pixel_count());
  return out;
}

std::vector<std::string> only_in(const image::Image& image, const image::Image& other) {
  std::vector<std::string> names;
  for (const auto& name : image.channels)
    if (!is_of_metrics(name) && image::channel_index(other, name) < 0) names.push_back(name);
  return names;
}

}  // namespace

ChannelDifferences channel_differences(const image::Image& result, const image::Image& reference) {
  ChannelDifferences out;
  for (std::size_t c = 0; c < result.channel_count(); ++c) {
    const int other = image::channel_index(reference, result.channels[c]);
    if (other >= 0 && !is_of_metrics(result.channels[c]))
      out.both.push_back(difference_of(result, reference, c, static_cast<std::size_t>(other)));
  }
  out.only_result = only_in(result, reference);
  out.only_reference = only_in(reference, result);
  return out;
}

}  // namespace orbs::metrics
