#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace orbs::image_test {

/// A PNG chunk with right length and CRC-32 (computed bit by bit, as the PNG specification's Annex D states
/// it).
std::string png_chunk(std::string_view type, std::string_view data);

/// A PNG without compression (one stored deflate block): `rows` holds each row's filter byte 0 and its
/// samples. `extra` are whole chunks to stand before the pixels.
std::string png_bytes(std::uint32_t width,
                      std::uint32_t height,
                      int depth,
                      int colour_type,
                      std::string_view rows,
                      std::string_view extra = {});

}  // namespace orbs::image_test
