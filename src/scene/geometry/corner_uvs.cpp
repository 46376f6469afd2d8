#include "scene/geometry/corner_uvs.h"

#include <array>
#include <bit>
#include <map>

namespace orbs::scene {

namespace {

// By their bits, so that numbers that are none are equal to themselves.
using VertexAndUv = std::array<std::uint32_t, 3>;

}  // namespace

void split_by_uvs(const CornerUvs& uvs,
                  std::vector<std::uint32_t>& corners,
                  std::vector<Vec3d>& places,
                  Mesh& mesh) {
  if (uvs.empty()) return;
  const std::vector<Vec2f> own = mesh.uvs;  // of the vertices
  std::vector<bool> is_taken(own.size(), false);
  std::map<VertexAndUv, std::uint32_t> split;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto vertex = corners[i];
    const Vec2f uv = i < uvs.size() && uvs[i] ? *uvs[i] : own[vertex];
    const VertexAndUv key{vertex, std::bit_cast<std::uint32_t>(uv.x), std::bit_cast<std::uint32_t>(uv.y)};
    const auto next = static_cast<std::uint32_t>(places.size());
    const auto [known, is_new] = split.try_emplace(key, is_taken[vertex] ? next : vertex);
    corners[i] = known->second;
    if (!is_new) continue;
    if (is_taken[vertex]) {
      const auto place = places[vertex];
      const auto normal = mesh.normals[vertex];
      const auto tangent = mesh.tangents[vertex];
      places.push_back(place);
      mesh.normals.push_back(normal);
      mesh.tangents.push_back(tangent);
      mesh.uvs.push_back(uv);
    } else {
      mesh.uvs[vertex] = uv;
      is_taken[vertex] = true;
    }
  }
}

}  // namespace orbs::scene
