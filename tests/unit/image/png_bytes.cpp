#include "unit/image/png_bytes.h"

namespace orbs::image_test {

namespace {

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xffU);
  return bytes;
}

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

std::uint32_t adler32(std::string_view bytes) {
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char byte : bytes) {
    a = (a + static_cast<unsigned char>(byte)) % 65521U;
    b = (b + a) % 65521U;
  }
  return b << 16 | a;
}

// RFC 1950 and 1951: header, one final stored block with its length and the complement, checksum.
std::string stored_zlib(std::string_view bytes) {
  const auto low = static_cast<char>(bytes.size() & 0xffU);
  const auto high = static_cast<char>(bytes.size() >> 8 & 0xffU);
  std::string stream("\x78\x01\x01", 3);
  stream += low;
  stream += high;
  stream += static_cast<char>(~low);
  stream += static_cast<char>(~high);
  stream += bytes;
  return stream + big_endian(adler32(bytes));
}

}  // namespace

std::string png_chunk(std::string_view type, std::string_view data) {
  std::string typed(type);
  typed += data;
  return big_endian(static_cast<std::uint32_t>(data.size())) + typed + big_endian(crc32(typed));
}

std::string png_bytes(std::uint32_t width,
                      std::uint32_t height,
                      int depth,
                      int colour_type,
                      std::string_view rows,
                      std::string_view extra) {
  std::string header = big_endian(width) + big_endian(height);
  header += static_cast<char>(depth);
  header += static_cast<char>(colour_type);
  header += std::string(3, '\0');
  std::string png("\x89PNG\r\n\x1a\n");
  png += png_chunk("IHDR", header);
  png += extra;
  return png + png_chunk("IDAT", stored_zlib(rows)) + png_chunk("IEND", "");
}

}  // namespace orbs::image_test
