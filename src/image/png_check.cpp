#include "image/png_check.h"

#include "base/error.h"

#include <array>
#include <cctype>
#include <cstdint>

#include <fmt/format.h>

namespace orbs::image {

namespace {

// PNG specification (ISO/IEC 15948), sections 5.2 (signature), 5.3 (chunk layout), 11.2.1 (IHDR), Annex D
// (CRC).
constexpr std::string_view kSignature{"\x89PNG\r\n\x1a\n", 8};
constexpr std::size_t kHeaderBytes = 13;
constexpr std::uint32_t kLargestSidePx = 1000000;  // libpng's own limit

constexpr std::array<std::uint32_t, 256> crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t n = 0; n < 256; ++n) {
    std::uint32_t c = n;
    for (int bit = 0; bit < 8; ++bit) c = (c & 1U) != 0 ? 0xedb88320U ^ (c >> 1) : c >> 1;
    table[n] = c;
  }
  return table;
}

std::uint32_t crc32(std::string_view bytes) {
  static constexpr auto kTable = crc_table();
  std::uint32_t crc = 0xffffffffU;
  for (const char byte : bytes) crc = kTable[(crc ^ static_cast<unsigned char>(byte)) & 0xffU] ^ (crc >> 8);
  return ~crc;
}

// Four bytes, the most significant first; the caller knows that they are there.
std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

struct Chunk {
  std::string_view type;
  std::string_view data;
  std::size_t whole_length;  // with length, type and CRC
};

Chunk chunk_at(std::string_view bytes, std::size_t at) {
  constexpr std::size_t kFrame = 12;  // length, type, CRC
  if (bytes.size() - at < kFrame) throw InputError("the file ends inside a PNG chunk");
  const std::size_t length = word_at(bytes, at);
  const auto type = bytes.substr(at + 4, 4);
  for (const char c : type)
    if (std::isalpha(static_cast<unsigned char>(c)) == 0)
      throw InputError(fmt::format("byte {} should start a PNG chunk, but no chunk type stands there", at));
  if (length > bytes.size() - at - kFrame)
    throw InputError(fmt::format("the file ends inside the PNG chunk {}", type));
  if (crc32(bytes.substr(at + 4, 4 + length)) != word_at(bytes, at + 8 + length))
    throw InputError(fmt::format("the checksum of the PNG chunk {} is wrong", type));
  return {type, bytes.substr(at + 8, length), length + kFrame};
}

bool is_depth_of_colour_type(int depth, int colour_type) {
  switch (colour_type) {
    case 0:
      return depth == 1 || depth == 2 || depth == 4 || depth == 8 || depth == 16;  // grey
    case 3:
      return depth == 1 || depth == 2 || depth == 4 || depth == 8;  // palette
    case 2:                                                         // RGB
    case 4:                                                         // grey and alpha
    case 6:
      return depth == 8 || depth == 16;  // RGB and alpha
    default:
      return false;
  }
}

void check_header(const Chunk& chunk) {
  if (chunk.data.size() != kHeaderBytes)
    throw InputError(
        fmt::format("the PNG header has {} bytes, expected {}", chunk.data.size(), kHeaderBytes));
  const std::uint32_t width = word_at(chunk.data, 0);
  const std::uint32_t height = word_at(chunk.data, 4);
  if (width == 0 || height == 0 || width > kLargestSidePx || height > kLargestSidePx)
    throw InputError(fmt::format("the PNG header says {} x {} px", width, height));
  if (!is_depth_of_colour_type(chunk.data[8], chunk.data[9]) || chunk.data[10] != 0 || chunk.data[11] != 0 ||
      chunk.data[12] < 0 || chunk.data[12] > 1)
    throw InputError("the PNG header holds a pixel format that PNG does not have");
}

// Chunks whose names start with a capital letter must be understood; of the palette, libpng prints what it
// dislikes.
class CriticalChunks {
 public:
  void add(const Chunk& chunk) {
    if (chunk.type == "IHDR") {
      if (seen_header_) throw InputError("the PNG has a second header IHDR");
      check_header(chunk);
      seen_header_ = true;
      needs_palette_ = chunk.data[9] == 3;
    } else if (!seen_header_) {
      throw InputError("the PNG does not start with its header IHDR");
    } else if (chunk.type == "PLTE") {
      check_palette(chunk);
    } else if (chunk.type == "IDAT") {
      if (needs_palette_ && !seen_palette_) throw InputError("the PNG has no palette before its pixels");
      seen_pixels_ = true;
    } else if (chunk.type != "IEND" && std::isupper(static_cast<unsigned char>(chunk.type[0])) != 0) {
      throw InputError(
          fmt::format("the PNG has the chunk {}, which nobody knows but all must understand", chunk.type));
    } else if (chunk.type == "IEND" && !seen_pixels_) {
      throw InputError("the PNG has no pixels");
    }
  }

 private:
  void check_palette(const Chunk& chunk) {
    constexpr std::size_t kMostBytes = 3 * 256;
    if (seen_palette_ || seen_pixels_)
      throw InputError("the palette of the PNG is not alone before its pixels");
    if (chunk.data.empty() || chunk.data.size() % 3 != 0 || chunk.data.size() > kMostBytes)
      throw InputError(fmt::format("the palette of the PNG has {} bytes, expected 3 a colour and at most {}",
                                   chunk.data.size(), kMostBytes));
    seen_palette_ = true;
  }

  bool seen_header_ = false;
  bool seen_palette_ = false;
  bool seen_pixels_ = false;
  bool needs_palette_ = false;
};

}  // namespace

void check_png(std::string_view bytes) {
  if (!bytes.starts_with(kSignature)) throw InputError("does not start as a PNG does");
  CriticalChunks critical;
  for (std::size_t at = kSignature.size();;) {
    const Chunk chunk = chunk_at(bytes, at);
    critical.add(chunk);
    if (chunk.type == "IEND") return;
    at += chunk.whole_length;
  }
}

}  // namespace orbs::image
