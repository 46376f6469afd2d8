#pragma once

#include "image/layers.h"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::image {

/// Named float channels over one rectangle, rows from the top, channels interleaved: value(x, y, c) =
/// pixels[(y * width + x) * channels + c]. Nothing is assumed about colour beyond the names: "R", "G", "B"
/// are linear Rec.709, "variance.R" is the variance of the mean of "R", and "layer.R" belongs to a named
/// layer.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;
  std::vector<float> pixels;
  std::map<std::string, std::string> attributes;  // text in the file's header: the provenance

  std::size_t channel_count() const { return channels.size(); }
  std::size_t pixel_count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  const float& at(int x, int y, std::size_t c) const { return pixels[index(x, y, c)]; }
  float& at(int x, int y, std::size_t c) { return pixels[index(x, y, c)]; }

 private:
  std::size_t index(int x, int y, std::size_t c) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
               channels.size() +
           c;
  }
};

/// Of the pixels in an EXR file. Half: 16-bit floats, but for channels "variance.*" and those of layers
/// (layers.h), which stay 32-bit floats: variances span more decades than half floats have, and the digits of
/// depths and numbers count. Float: all as they are.
enum class Precision { Half, Float };

/// Of an EXR file. Zip loses nothing; None is for readers of a few lines.
enum class Compression { Zip, None };

/// Black image with these channels.
Image make_image(int width, int height, std::vector<std::string> channels);

/// Index of a channel, -1 when the image has none of that name.
int channel_index(const Image& image, std::string_view name);

/// The channels `prefix`R, `prefix`G, `prefix`B alone as an image with channels R, G, B ("" for the colour
/// itself, "variance." for its variance). InputError when one is missing.
Image select_rgb(const Image& image, std::string_view prefix);

/// The three named channels as an image with channels R, G, B; attributes are not kept. InputError when one
/// is missing.
Image select_channels(const Image& image, const std::array<std::string, 3>& channels);

/// R, G and B of each. InputError as select_rgb.
std::vector<Image> colours_of(const std::vector<Image>& images);

/// Whether R, G and B are the same to the bit, and the sizes. InputError as select_rgb.
bool has_same_colours(const Image& a, const Image& b);

/// The image of a renderer with a box filter at 1/divisor of the width and height: each pixel is the mean of
/// divisor x divisor pixels, in double. A channel "variance.*" becomes the variance of that mean, the sum of
/// the variances over divisor^4, because the noise of neighbouring pixels is independent. Attributes are
/// kept. InputError when width or height cannot be divided.
Image reduced_image(const Image& image, int divisor);

}  // namespace orbs::image
