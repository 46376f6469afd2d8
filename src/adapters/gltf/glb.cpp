#include "adapters/gltf/glb.h"

#include "base/error.h"

#include <cstdint>
#include <limits>

#include <fmt/format.h>

namespace orbs::adapters::gltf {

namespace {

void append_number(std::string& bytes, std::size_t number) {
  for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 0xffU);
}

// A chunk is filled up to a multiple of four bytes, which its length counts.
void append_chunk(std::string& bytes, std::string_view type, std::string_view content, char filler) {
  const std::size_t length = (content.size() + 3) / 4 * 4;
  append_number(bytes, length);
  bytes += type;
  bytes += content;
  bytes.append(length - content.size(), filler);
}

}  // namespace

std::string glb(std::string_view json, std::string_view buffer) {
  using namespace std::string_view_literals;
  constexpr std::size_t kVersion = 2;
  constexpr std::size_t kHeader = 12;
  std::string chunks;
  append_chunk(chunks, "JSON"sv, json, ' ');
  if (!buffer.empty()) append_chunk(chunks, "BIN\0"sv, buffer, '\0');
  const std::size_t size = kHeader + chunks.size();
  if (size > std::numeric_limits<std::uint32_t>::max())
    throw InputError(fmt::format("the scene has {} bytes as glTF; a .glb file has at most 4 GiB", size));
  std::string bytes = "glTF";
  append_number(bytes, kVersion);
  append_number(bytes, size);
  return bytes + chunks;
}

}  // namespace orbs::adapters::gltf
