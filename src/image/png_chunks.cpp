#include "image/png_chunks.h"

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
  std::string_view whole;  // with length and CRC, as it stands in the file
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
  return {type, bytes.substr(at + 8, length), bytes.substr(at, length + kFrame)};
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
  if (chunk.type != "IHDR" || chunk.data.size() != kHeaderBytes)
    throw InputError("the PNG does not start with its header IHDR");
  const std::uint32_t width = word_at(chunk.data, 0);
  const std::uint32_t height = word_at(chunk.data, 4);
  if (width == 0 || height == 0 || width > kLargestSidePx || height > kLargestSidePx)
    throw InputError(fmt::format("the PNG header says {} x {} px", width, height));
  if (!is_depth_of_colour_type(chunk.data[8], chunk.data[9]) || chunk.data[10] != 0 || chunk.data[11] != 0 ||
      chunk.data[12] < 0 || chunk.data[12] > 1)
    throw InputError("the PNG header holds a pixel format that PNG does not have");
}

}  // namespace

std::string pixel_chunks(std::string_view bytes) {
  if (!bytes.starts_with(kSignature)) throw InputError("does not start as a PNG does");
  std::string kept(kSignature);
  bool has_pixels = false;
  for (std::size_t at = kSignature.size();;) {
    const Chunk chunk = chunk_at(bytes, at);
    if (at == kSignature.size()) check_header(chunk);
    has_pixels = has_pixels || chunk.type == "IDAT";
    if (chunk.type == "IHDR" || chunk.type == "PLTE" || chunk.type == "tRNS" || chunk.type == "IDAT" ||
        chunk.type == "IEND")
      kept += chunk.whole;
    if (chunk.type == "IEND") break;
    at += chunk.whole.size();
  }
  if (!has_pixels) throw InputError("the PNG has no pixels");
  return kept;
}

}  // namespace orbs::image
