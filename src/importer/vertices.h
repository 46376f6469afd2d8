#pragma once

#include "base/matrix.h"
#include "importer/accessors.h"

#include <array>
#include <cstdint>
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
  std::vector<Vec3d> normals;   // none where the file has none
  std::vector<Vec3d> tangents;  // as many as positions; zero where the file has none
  std::vector<Vec2f> uvs;
};

/// v is 0 in the bottom row. All zero if the primitive has no such set.
std::vector<Vec2f> read_uvs(const Source& source,
                            const tinygltf::Primitive& primitive,
                            int set,
                            std::size_t count,
                            const std::string& where);

/// With morph targets and bones as the pose says. `uv_set`: which of the coordinates are wanted.
Vertices read_vertices(const Source& source,
                       const tinygltf::Primitive& primitive,
                       const Pose& pose,
                       int uv_set,
                       const std::string& where);

/// The corners of its triangles, of strips and fans too.
std::vector<std::array<std::uint32_t, 3>> read_triangles(const Source& source,
                                                         const tinygltf::Primitive& primitive,
                                                         std::size_t vertices,
                                                         const std::string& where);

}  // namespace orbs::importer
