#pragma once

#include "base/matrix.h"
#include "importer/accessors.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace orbs::importer {

/// Where the bones of a skin are, by the numbers that vertices name them by; and how much of each morph
/// target there is.
struct Pose {
  std::vector<Mat4> joints{};
  std::vector<double> weights{};
};

/// The vertices of a primitive as a mesh of ours has them.
struct Vertices {
  std::vector<Vec3d> positions;
  std::vector<Vec3d> normals;           // none where the file has none
  std::vector<Vec3d> tangents;          // as many as positions; zero where the file has none
  std::vector<double> tangent_sides{};  // as many; -1 where v grows away from normal x tangent, else 1
  std::vector<Vec2f> uvs;               // of the colour texture
  std::vector<Vec2f> map_uvs;           // of the texture of metal and roughness
  std::vector<Vec2f> second_uvs{};      // of a normal map that has others than the colour; else none
};

/// Which of the sets of coordinates the textures use.
struct UvSets {
  int colour = 0;
  int map = 0;
  std::optional<int> second{};
};

/// With morph targets and bones as the pose says.
Vertices read_vertices(const Source& source,
                       const tinygltf::Primitive& primitive,
                       const Pose& pose,
                       const UvSets& sets,
                       const std::string& where);

/// The corners of its triangles, of strips and fans too.
std::vector<std::array<std::uint32_t, 3>> read_triangles(const Source& source,
                                                         const tinygltf::Primitive& primitive,
                                                         std::size_t vertices,
                                                         const std::string& where);

}  // namespace orbs::importer
