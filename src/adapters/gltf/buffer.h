#pragma once

#include "base/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::json {
class Writer;
}

/// The one buffer of a file: its bytes, the views into it and the arrays of numbers in these.
namespace orbs::adapters::gltf {

/// Codes of OpenGL, which glTF uses.
constexpr int kVertices = 34962;
constexpr int kIndices = 34963;
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;

struct View {
  std::size_t offset = 0;
  std::size_t length = 0;
  int target = 0;  // 0: neither vertices nor indices
};

struct Accessor {
  int view = 0;
  int component = kFloat;
  const char* type = "";
  std::size_t count = 0;
  std::vector<double> min{};  // of positions, which must have them
  std::vector<double> max{};
};

struct Buffer {
  std::string bytes;
  std::vector<View> views;
  std::vector<Accessor> accessors;
};

/// Each adds an array and returns the index of its accessor. Arrays have at least one element.
int add_positions(Buffer& buffer, const std::vector<Vec3f>& positions);
int add_normals(Buffer& buffer, const std::vector<Vec3f>& normals);
int add_tangents(Buffer& buffer, const std::vector<std::array<float, 4>>& tangents);
int add_uvs(Buffer& buffer, const std::vector<Vec2f>& uvs);
int add_triangles(Buffer& buffer, const std::vector<std::array<std::uint32_t, 3>>& triangles);

/// Adds a file, such as an image, and returns the index of its view.
int add_file(Buffer& buffer, std::string_view bytes);

/// The members "accessors", "bufferViews" and "buffers"; none where the buffer is empty.
void write_buffer(json::Writer& out, const Buffer& buffer);

}  // namespace orbs::adapters::gltf
