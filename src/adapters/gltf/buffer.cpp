#include "adapters/gltf/buffer.h"

#include "json/writer.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

namespace orbs::adapters::gltf {

namespace {

// The numbers of glTF are little-endian, as those of every machine that the project is compiled for.
static_assert(std::endian::native == std::endian::little);

template <typename Element>
std::string_view bytes_of(const std::vector<Element>& elements) {
  return {reinterpret_cast<const char*>(elements.data()), elements.size() * sizeof(Element)};
}

// Every view begins at a multiple of four, the size of the largest number.
int add_view(Buffer& buffer, std::string_view bytes, int target) {
  buffer.bytes.resize((buffer.bytes.size() + 3) / 4 * 4, '\0');
  buffer.views.push_back({buffer.bytes.size(), bytes.size(), target});
  buffer.bytes += bytes;
  return static_cast<int>(buffer.views.size()) - 1;
}

int add_accessor(Buffer& buffer, Accessor accessor) {
  buffer.accessors.push_back(std::move(accessor));
  return static_cast<int>(buffer.accessors.size()) - 1;
}

long long number(std::size_t value) { return static_cast<long long>(value); }

}  // namespace

int add_positions(Buffer& buffer, const std::vector<Vec3f>& positions) {
  static_assert(sizeof(Vec3f) == 12);
  assert(!positions.empty());
  Vec3f low = positions.front();
  Vec3f high = low;
  for (const Vec3f p : positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const auto numbers = [](Vec3f v) { return std::vector<double>{v.x, v.y, v.z}; };
  return add_accessor(buffer, {add_view(buffer, bytes_of(positions), kVertices), kFloat, "VEC3",
                               positions.size(), numbers(low), numbers(high)});
}

int add_normals(Buffer& buffer, const std::vector<Vec3f>& normals) {
  return add_accessor(buffer,
                      {add_view(buffer, bytes_of(normals), kVertices), kFloat, "VEC3", normals.size()});
}

int add_tangents(Buffer& buffer, const std::vector<std::array<float, 4>>& tangents) {
  return add_accessor(buffer,
                      {add_view(buffer, bytes_of(tangents), kVertices), kFloat, "VEC4", tangents.size()});
}

int add_uvs(Buffer& buffer, const std::vector<Vec2f>& uvs) {
  static_assert(sizeof(Vec2f) == 8);
  return add_accessor(buffer, {add_view(buffer, bytes_of(uvs), kVertices), kFloat, "VEC2", uvs.size()});
}

int add_triangles(Buffer& buffer, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  return add_accessor(buffer, {add_view(buffer, bytes_of(triangles), kIndices), kUnsignedInt, "SCALAR",
                               3 * triangles.size()});
}

int add_file(Buffer& buffer, std::string_view bytes) { return add_view(buffer, bytes, 0); }

void write_buffer(json::Writer& out, const Buffer& buffer) {
  if (buffer.bytes.empty()) return;
  if (!buffer.accessors.empty()) {
    out.key("accessors").begin_array();
    for (const Accessor& accessor : buffer.accessors) {
      out.begin_object().member("bufferView", accessor.view).member("componentType", accessor.component);
      out.member("count", number(accessor.count)).member("type", accessor.type);
      if (!accessor.min.empty()) {
        out.key("min").numbers(accessor.min);
        out.key("max").numbers(accessor.max);
      }
      out.end_object();
    }
    out.end_array();
  }
  out.key("bufferViews").begin_array();
  for (const View& view : buffer.views) {
    out.begin_object().member("buffer", 0).member("byteOffset", number(view.offset));
    out.member("byteLength", number(view.length));
    if (view.target != 0) out.member("target", view.target);
    out.end_object();
  }
  out.end_array().key("buffers").begin_array().begin_object();
  out.member("byteLength", number(buffer.bytes.size())).end_object().end_array();
}

}  // namespace orbs::adapters::gltf
