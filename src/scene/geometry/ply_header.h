#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::scene {

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

struct PlyProperty {
  std::string name;
  std::string type;
  std::string count_type;  // of lists, else empty
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;  // one or more
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  // up to the data
};

/// Bytes of a number of that type ("uchar", "float32"); 0 if there is no such type.
std::size_t ply_bytes_of(const std::string& type);

/// Whether an element has a property.
bool has_property(const PlyElement& element, std::string_view name);

/// The header at the front of a PLY file. InputError with file and line.
PlyHeader parse_ply_header(const std::string& name, std::string_view bytes);

}  // namespace orbs::scene
