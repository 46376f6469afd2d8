#pragma once

#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace orbs::adapters::hydra {

static_assert(std::endian::native == std::endian::little,
              "HydraCore3's files are written without swapping bytes");

/// Appends the bytes of a number, as HydraCore3's meshes and images hold them.
template <typename Number>
void append_bytes(std::string& bytes, Number value) {
  std::array<char, sizeof value> raw{};
  std::memcpy(raw.data(), &value, sizeof value);
  bytes.append(raw.data(), raw.size());
}

}  // namespace orbs::adapters::hydra
