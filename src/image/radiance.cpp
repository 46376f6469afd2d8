#include "image/radiance.h"

#include "base/error.h"
#include "image/radiance_header.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace orbs::image {

namespace {

using Rgbe = std::array<std::uint8_t, 4>;

class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  std::uint8_t next() {
    if (at_ == bytes_.size()) throw InputError("the file ends before its last pixel");
    return static_cast<std::uint8_t>(bytes_[at_++]);
  }
  bool starts_with(std::string_view start) const { return bytes_.substr(at_).starts_with(start); }
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

[[noreturn]] void refuse_run() { throw InputError("a run of equal pixels goes beyond its line"); }

// The four numbers of all pixels one after another, in runs: more than 128 is a run of as many equal ones
// as are above it, less is as many different ones.
void read_runs(Bytes& in, std::vector<Rgbe>& line) {
  for (std::size_t part = 0; part < 4; ++part)
    for (std::size_t x = 0; x < line.size();) {
      constexpr std::uint8_t kEqual = 128;
      const auto code = in.next();
      const std::size_t count = code > kEqual ? code - kEqual : code;
      if (count == 0 || count > line.size() - x) refuse_run();
      const auto value = in.next();
      for (std::size_t i = 0; i < count; ++i)
        line[x++].at(part) = code > kEqual || i == 0 ? value : in.next();
    }
}

// Pixel by pixel; mantissas of 1 say that the last pixel is repeated as often as the exponent says, with
// eight more bits of the number in each that follows.
void read_pixels_of(Bytes& in, std::vector<Rgbe>& line) {
  unsigned shift = 0;
  for (std::size_t x = 0; x < line.size();) {
    Rgbe pixel{};
    for (auto& part : pixel) part = in.next();
    const bool is_run = pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1;
    if (!is_run) {
      line[x++] = pixel;
      shift = 0;
      continue;
    }
    const std::size_t count = shift < 24 ? std::size_t{pixel[3]} << shift : line.size() + 1;
    if (x == 0 || count > line.size() - x) refuse_run();
    for (std::size_t i = 0; i < count; ++i, ++x) line[x] = line[x - 1];
    shift += 8;
  }
}

// Lines of other lengths are never stored in runs of numbers.
void read_line(Bytes& in, std::vector<Rgbe>& line) {
  constexpr std::size_t kLeast = 8;
  constexpr std::size_t kMost = 32767;
  const auto length = line.size();
  const std::array<char, 4> start{2, 2, static_cast<char>(length >> 8U), static_cast<char>(length & 0xffU)};
  if (length < kLeast || length > kMost || !in.starts_with({start.data(), start.size()}))
    return read_pixels_of(in, line);
  for (std::size_t i = 0; i < start.size(); ++i) in.next();
  read_runs(in, line);
}

// An exponent of 0 stands for black.
float number_of(std::uint8_t mantissa, std::uint8_t exponent, double multiplied_by) {
  constexpr int kBias = 128 + 8;
  if (exponent == 0) return 0;
  return static_cast<float>(std::ldexp(static_cast<double>(mantissa), exponent - kBias) / multiplied_by);
}

void read_pixels(Bytes& in, const RadianceHeader& header, Image& image) {
  const auto& order = header.order;
  const int lines = order.has_columns ? order.width_px : order.height_px;
  std::vector<Rgbe> line(static_cast<std::size_t>(order.has_columns ? order.height_px : order.width_px));
  for (int i = 0; i < lines; ++i) {
    read_line(in, line);
    for (int k = 0; k < static_cast<int>(line.size()); ++k) {
      const int along_x = order.has_columns ? i : k;
      const int along_y = order.has_columns ? k : i;
      const int x = order.is_left_to_right ? along_x : order.width_px - 1 - along_x;
      const int y = order.is_top_to_bottom ? along_y : order.height_px - 1 - along_y;
      const auto& pixel = line[static_cast<std::size_t>(k)];
      for (std::size_t c = 0; c < image.channel_count(); ++c) {
        const std::uint8_t mantissa = c < 3 ? pixel.at(c) : 1;  // one, of a step
        image.at(x, y, c) = number_of(mantissa, pixel[3], header.multiplied_by.at(c % 3));
      }
    }
  }
}

}  // namespace

namespace {

Image decoded(std::string_view bytes, Wanted wanted, std::vector<std::string> channels) {
  const auto header = radiance_header(bytes);
  const Window whole{0, 0, header.order.width_px, header.order.height_px};
  check_size({whole, whole, 3}, bytes.size());
  Image image{whole.width, whole.height, std::move(channels), {}, header.attributes};
  if (wanted == Wanted::Header) return image;
  image.pixels.resize(image.pixel_count() * image.channel_count());
  Bytes in(bytes.substr(header.length));
  read_pixels(in, header, image);
  if (in.left() > 0)
    throw InputError(fmt::format("{} bytes follow its last pixel: its header says {} x {} px; write it again",
                                 in.left(), image.width, image.height));
  return image;
}

}  // namespace

Image decoded_radiance(std::string_view bytes, Wanted wanted) {
  return decoded(bytes, wanted, {"R", "G", "B"});
}

Image decoded_radiance_with_steps(std::string_view bytes) {
  std::vector<std::string> channels{"R", "G", "B"};
  channels.insert(channels.end(), kRgbeSteps.begin(), kRgbeSteps.end());
  return decoded(bytes, Wanted::Pixels, std::move(channels));
}

}  // namespace orbs::image
