#include "faults/channels.h"

#include "faults/pixels.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::faults {

using image::Image;

Image ChannelOrder::apply(const Image& image) const {
  Image out = image;
  for (std::size_t colour = 0; colour < 3; ++colour)
    for (const char* layer : {"", "variance."}) {
      const int to = image::channel_index(image, std::string(layer) + kColours.at(colour));
      const int source = image::channel_index(image, std::string(layer) + kColours.at(from.at(colour)));
      if (to < 0 || source < 0) continue;
      for (std::size_t i = 0; i < image.pixels.size(); i += image.channel_count())
        out.pixels[i + static_cast<std::size_t>(to)] = image.pixels[i + static_cast<std::size_t>(source)];
    }
  return out;
}

std::string ChannelOrder::text() const {
  if (from == std::array<std::size_t, 3>{2, 1, 0}) return "with R and B swapped";
  if (from == std::array<std::size_t, 3>{1, 0, 2}) return "with R and G swapped";
  if (from == std::array<std::size_t, 3>{0, 2, 1}) return "with G and B swapped";
  return fmt::format("with R, G, B in the order {}, {}, {}", kColours.at(from[0]), kColours.at(from[1]),
                     kColours.at(from[2]));
}

ChannelOrder most_visible_swap(const Image& image) {
  ChannelOrder most;
  double largest = -1;
  for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += image.channel_count()) {
      const double d = static_cast<double>(image.pixels[i + colour_index(image, a)]) -
                       static_cast<double>(image.pixels[i + colour_index(image, b)]);
      sum += d * d;
    }
    if (sum <= largest) continue;
    largest = sum;
    most = {};
    std::swap(most.from.at(a), most.from.at(b));
  }
  return most;
}

Image ColourMatrix::apply(const Image& image) const {
  Image out = image;
  const std::array<std::size_t, 3> channels{colour_index(image, 0), colour_index(image, 1),
                                            colour_index(image, 2)};
  for (std::size_t i = 0; i < image.pixels.size(); i += image.channel_count())
    for (std::size_t colour = 0; colour < 3; ++colour) {
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c)
        sum += rows.at(colour).at(c) * static_cast<double>(image.pixels[i + channels.at(c)]);
      out.pixels[i + channels.at(colour)] = static_cast<float>(sum);
    }
  return out;
}

ColourMatrix less_saturated(double share) {
  constexpr std::array<double, 3> kLuminance{0.2126, 0.7152, 0.0722};
  ColourMatrix matrix;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t c = 0; c < 3; ++c)
      matrix.rows.at(row).at(c) = share * kLuminance.at(c) + (row == c ? 1 - share : 0);
  return matrix;
}

Image Alpha::apply(const Image& image) const {
  constexpr const char* kName = "A";
  auto names = image.channels;
  if (image::channel_index(image, kName) < 0) names.emplace_back(kName);
  Image out = image::make_image(image.width, image.height, names);
  const auto own = static_cast<std::size_t>(image::channel_index(out, kName));
  for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel) {
    for (std::size_t c = 0; c < image.channel_count(); ++c) {
      const float value = image.pixels[pixel * image.channel_count() + c];
      const float factor = image::is_variance(names[c]) ? alpha[pixel] * alpha[pixel] : alpha[pixel];
      float& changed = out.pixels[pixel * names.size() + c];
      if (kind == Kind::Multiplied) {
        changed = value * factor;
      } else {
        changed = factor > 0 ? value / factor : value;
      }
    }
    out.pixels[pixel * names.size() + own] = alpha[pixel];
  }
  return out;
}

std::string Alpha::text() const {
  return fmt::format("{} by its alpha once too often", kind == Kind::Multiplied ? "multiplied" : "divided");
}

Image LightPaths::apply(const Image& image) const {
  Image out = image;
  for (const auto& one : missing) {
    const auto layer = image::select_rgb(image, "path." + one + ".");
    for (std::size_t colour = 0; colour < 3; ++colour) {
      const auto channel = colour_index(image, colour);
      for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel)
        out.pixels[pixel * image.channel_count() + channel] -= layer.pixels[3 * pixel + colour];
    }
  }
  return out;
}

std::string LightPaths::text() const {
  if (is_direct_left) return "direct light only";
  return fmt::format("without the light paths {}", fmt::join(missing, ", "));
}

Image EmittersOnly::apply(const Image& image) const {
  Image out = image;
  const auto count = image.channel_count();
  for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel)
    if (lit[pixel] == 0)
      std::fill_n(out.pixels.begin() + static_cast<std::ptrdiff_t>(pixel * count), count, 0.0F);
  return out;
}

std::string EmittersOnly::text() const {
  return "emitters alone: no surface reflects their light, as with a trace depth of 0";
}

Image NoMisWeight::apply(const Image& image) const {
  Image out = image;
  for (std::size_t c = 0; c < image.channel_count(); ++c)
    for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel)
      if (emitters[pixel] == 0)
        out.pixels[pixel * image.channel_count() + c] *= image::is_variance(image.channels[c]) ? 4.0F : 2.0F;
  return out;
}

std::string NoMisWeight::text() const {
  return "right at emitters and twice as bright elsewhere: light sampling and BSDF sampling both count in full "
         "(no MIS weight)";
}

std::string OtherImage::text() const { return fmt::format("the image of '{}'", name); }

}  // namespace orbs::faults
