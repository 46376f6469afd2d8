#include "report/packed_image.h"

#include "base/error.h"
#include "base/parallel.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "image/reduced_precision.h"
#include "json/writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zlib.h>

namespace orbs::report {

std::string gzip(std::string_view bytes, int level) {
  constexpr int kGzipWindow = 15 + 16;  // the largest window; 16 asks for the gzip frame
  constexpr int kMemory = 8;            // zlib's default
  z_stream stream{};
  if (deflateInit2(&stream, level, Z_DEFLATED, kGzipWindow, kMemory, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib could not start");
  std::string out;
  std::array<char, 1U << 16U> piece{};
  // zlib counts in 32 bits, so what is larger goes in by parts.
  constexpr std::size_t kMostAtOnce = std::numeric_limits<std::uint32_t>::max() / 2;
  int state = Z_OK;
  do {
    const auto part = bytes.substr(0, kMostAtOnce);
    bytes.remove_prefix(part.size());
    // zlib's interface takes a pointer to bytes that it does not change as one that it could.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(part.data()));
    stream.avail_in = static_cast<uInt>(part.size());
    do {
      stream.next_out = reinterpret_cast<Bytef*>(piece.data());
      stream.avail_out = static_cast<uInt>(piece.size());
      state = deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
      out.append(piece.data(), piece.size() - stream.avail_out);
    } while (stream.avail_out == 0);
  } while (state != Z_STREAM_END);
  deflateEnd(&stream);
  return out;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto group = bytes.substr(i, 3);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8U | (k < group.size() ? static_cast<unsigned char>(group[k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += k <= group.size() ? kDigits[bits >> (18 - 6 * k) & 63U] : '=';
  }
  return out;
}

static_assert(std::endian::native == std::endian::little, "planes are copied as they lie in memory");

namespace {

struct Plane {
  std::string name;
  bool is_half = false;
  bool is_exact = true;
  std::string bytes;
};

// The values of a channel, one behind the other, as `stored` makes them.
template <typename Value, typename Stored>
std::string bytes_of(const image::Image& image, std::size_t channel, Stored stored) {
  std::string bytes(image.pixel_count() * sizeof(Value), '\0');
  for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel) {
    const Value value = stored(image.pixels[pixel * image.channel_count() + channel]);
    std::memcpy(bytes.data() + pixel * sizeof(Value), &value, sizeof(Value));
  }
  return bytes;
}

// The highest bytes of all values, then the next ones, and so on, each less the byte before it, as OpenEXR
// does before it deflates (ImfZip.cpp): the gzip of halves is then 12 % smaller for renders with noise and
// 25 % for references (164 images at 1/4 of the size).
std::string separated(const std::string& bytes, std::size_t value_size) {
  std::string out;
  out.reserve(bytes.size());
  unsigned last = 0;
  for (std::size_t place = value_size; place-- > 0;)
    for (std::size_t at = place; at < bytes.size(); at += value_size) {
      const unsigned byte = static_cast<unsigned char>(bytes[at]);
      out += static_cast<char>(static_cast<unsigned char>(byte - last));
      last = byte;
    }
  return out;
}

// What the rounding to half would do to a channel.
struct HalfLoss {
  bool is_exact = true;
  bool overflows = false;
};

HalfLoss loss_as_half(const image::Image& image, std::size_t channel) {
  HalfLoss loss;
  for (std::size_t i = channel; i < image.pixels.size(); i += image.channel_count()) {
    const float value = image.pixels[i];
    if (std::isnan(value)) continue;
    if (image::float_of_half(image::half_bits(value)) == value) continue;
    loss.is_exact = false;
    loss.overflows = loss.overflows || std::fabs(value) > image::kLargestHalf;
    if (loss.overflows) break;
  }
  return loss;
}

Plane plane_of(const image::Image& image, std::size_t channel, Rounding rounding, Packing packing) {
  const auto loss = loss_as_half(image, channel);
  Plane plane;
  plane.name = image.channels[channel].substr(image.channels[channel].rfind('.') + 1);
  plane.is_half = loss.is_exact || (rounding == Rounding::Rounded && !loss.overflows);
  plane.is_exact = loss.is_exact || !plane.is_half;
  if (plane.is_half) {
    plane.bytes = bytes_of<std::uint16_t>(image, channel, image::half_bits);
  } else {
    plane.bytes = bytes_of<float>(image, channel, [](float value) { return value; });
  }
  if (packing == Packing::Small)
    plane.bytes = separated(plane.bytes, plane.is_half ? sizeof(std::uint16_t) : sizeof(float));
  return plane;
}

std::string layer_of(const std::string& channel) {
  const auto dot = channel.rfind('.');
  return dot == std::string::npos ? "" : channel.substr(0, dot);
}

std::string header_text(const image::Image& image,
                        std::string_view layer,
                        const std::vector<Plane>& planes,
                        Packing packing) {
  json::Writer out;
  out.begin_object().member("format", "orbs-image/2");
  out.member("width", image.width).member("height", image.height);
  out.member("separated", packing == Packing::Small);
  out.member("layer", layer).member("layers", layers_of(image)).key("channels").begin_array();
  for (const auto& plane : planes)
    out.begin_object()
        .member("name", plane.name)
        .member("type", plane.is_half ? "half" : "float")
        .member("exact", plane.is_exact)
        .end_object();
  out.end_array().key("attributes").begin_object();
  for (const auto& [name, text] : image.attributes) out.member(name, text);
  return out.end_object().end_object().text();
}

}  // namespace

std::vector<std::string> layers_of(const image::Image& image) {
  std::vector<std::string> layers;
  for (const auto& channel : image.channels)
    if (const auto layer = layer_of(channel); std::find(layers.begin(), layers.end(), layer) == layers.end())
      layers.push_back(layer);
  return layers;
}

std::string packed_image(const image::Image& image,
                         std::string_view layer,
                         Rounding rounding,
                         Packing packing) {
  std::vector<std::size_t> channels;
  for (std::size_t c = 0; c < image.channel_count(); ++c)
    if (layer_of(image.channels[c]) == layer) channels.push_back(c);
  if (channels.empty())
    throw InputError(
        fmt::format("the image has no layer '{}'; it has '{}'", layer, fmt::join(layers_of(image), "', '")));
  std::vector<Plane> planes(channels.size());
  for_each_index(static_cast<int>(channels.size()), 0, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    planes[at] = plane_of(image, channels[at], rounding, packing);
  });
  auto header = header_text(image, layer, planes, packing);
  constexpr std::size_t kAlignment = 8;
  while ((4 + header.size()) % kAlignment != 0) header += ' ';
  const auto length = static_cast<std::uint32_t>(header.size());
  std::string bytes(sizeof(length), '\0');
  std::memcpy(bytes.data(), &length, sizeof(length));
  bytes += header;
  for (auto& plane : planes) {
    bytes += plane.bytes;
    plane.bytes = {};
  }
  constexpr int kFast = 1;
  constexpr int kSmall = 9;
  return gzip(bytes, packing == Packing::Fast ? kFast : kSmall);
}

namespace {

// Means of the displayed values, not of the light: what a viewer does that shrinks the PNG, so that the image
// does not change its look when the floats arrive and are drawn pixel by pixel.
image::Image shrunk(const image::Image& shown, int factor) {
  const auto pieces = [&](int size) { return (size + factor - 1) / factor; };
  auto small = image::make_image(pieces(shown.width), pieces(shown.height), shown.channels);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      const int right = std::min(shown.width, (x + 1) * factor);
      const int bottom = std::min(shown.height, (y + 1) * factor);
      for (std::size_t c = 0; c < shown.channel_count(); ++c) {
        double sum = 0;
        for (int v = y * factor; v < bottom; ++v)
          for (int u = x * factor; u < right; ++u) sum += static_cast<double>(shown.at(u, v, c));
        small.at(x, y, c) = static_cast<float>(sum / ((right - x * factor) * (bottom - y * factor)));
      }
    }
  return small;
}

}  // namespace

std::string preview_png(const image::Image& image) {
  const auto shown = image::display_image(image);
  const int side = std::max(shown.width, shown.height);
  const int factor = (side + kPreviewSide_px - 1) / kPreviewSide_px;
  return image::png_bytes(factor <= 1 ? shown : shrunk(shown, factor));
}

}  // namespace orbs::report
