#include "image/pfm.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace orbs::image {

namespace {

// "PFM Portable FloatMap Image Format", https://www.pauldebevec.com/Research/HDR/PFM/
constexpr std::string_view kBlanks = " \t\r\n";

struct Header {
  int width_px = 0;
  int height_px = 0;
  std::size_t channels = 0;
  bool is_little_endian = false;
  std::size_t length = 0;  // in bytes
};

[[noreturn]] void refuse_header() {
  throw InputError(
      "is no readable .pfm image: expected 'PF' or 'Pf', the width, the height, -1.0, and a line "
      "end behind each of the three lines");
}

// Of the header at most four words, each with one blank behind it; further blanks stand before the next.
std::string_view next_word(std::string_view bytes, std::size_t& at) {
  const auto start = bytes.find_first_not_of(kBlanks, at);
  const auto end = bytes.find_first_of(kBlanks, start);
  constexpr std::size_t kLongest = 40;
  if (start == std::string_view::npos || end == std::string_view::npos || end - start > kLongest)
    refuse_header();
  at = end + 1;
  return bytes.substr(start, end - start);
}

int length_of(std::string_view word) {
  constexpr long long kMost = 1 << 24;
  const auto length = to_integer(word);
  if (!length || *length < 0 || *length > kMost) refuse_header();
  return static_cast<int>(*length);
}

Header header_of(std::string_view bytes) {
  Header header;
  const auto magic = bytes.substr(0, 2);
  if (magic != "PF" && magic != "Pf") refuse_header();
  header.channels = magic == "PF" ? 3 : 1;
  header.length = magic.size();
  header.width_px = length_of(next_word(bytes, header.length));
  header.height_px = length_of(next_word(bytes, header.length));
  const auto scale = to_number(next_word(bytes, header.length));
  if (!scale) refuse_header();
  if (std::fabs(*scale) != 1)
    throw InputError(
        fmt::format("its scale is {}; expected -1 or 1: some programs multiply by it, others do "
                    "not",
                    *scale));
  header.is_little_endian = *scale < 0;
  return header;
}

// A blank too many behind the scale would shift each pixel by a byte.
void check_length(const Header& header, std::string_view bytes) {
  const auto expected = static_cast<std::uint64_t>(header.width_px) *
                        static_cast<std::uint64_t>(header.height_px) * header.channels * sizeof(float);
  const std::uint64_t found = bytes.size() - header.length;
  if (found == expected) return;
  const bool has_carriage_return = bytes[header.length - 1] == '\r' && bytes.substr(header.length, 1) == "\n";
  throw InputError(
      fmt::format("{} bytes follow its header of {} x {} px with {} channels, expected {}{}", found,
                  header.width_px, header.height_px, header.channels, expected,
                  has_carriage_return ? "; its header ends lines with CR LF: write it with LF alone" : ""));
}

float float_at(const char* bytes, bool is_little_endian) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < sizeof word; ++i) {
    const std::size_t place = is_little_endian ? sizeof word - 1 - i : i;
    word = word << 8U | static_cast<unsigned char>(bytes[place]);
  }
  float value = 0;
  std::memcpy(&value, &word, sizeof value);
  return value;
}

}  // namespace

Image decoded_pfm(std::string_view bytes, Wanted wanted) {
  const auto header = header_of(bytes);
  const Window whole{0, 0, header.width_px, header.height_px};
  check_size({whole, whole, static_cast<int>(header.channels)}, bytes.size());
  check_length(header, bytes);
  const std::vector<std::string> names =
      header.channels == 3 ? std::vector<std::string>{"R", "G", "B"} : std::vector<std::string>{"Y"};
  Image image{whole.width, whole.height, names, {}, {}};
  if (wanted == Wanted::Header) return image;
  const std::size_t row = static_cast<std::size_t>(whole.width) * header.channels;
  image.pixels.resize(row * static_cast<std::size_t>(whole.height));
  const char* from = bytes.data() + header.length;
  for (std::size_t y = static_cast<std::size_t>(whole.height); y-- > 0;)
    for (std::size_t i = 0; i < row; ++i, from += sizeof(float))
      image.pixels[y * row + i] = float_at(from, header.is_little_endian);
  return image;
}

}  // namespace orbs::image
