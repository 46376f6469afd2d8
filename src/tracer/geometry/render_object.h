#pragma once

#include "tracer/geometry/transforms.h"

#include <array>
#include <cstdint>
#include <vector>

namespace orbs::tracer {

/// What shading needs of a triangle, precomputed and contiguous in memory.
struct TriangleCache {
  Vec3f corner;
  Vec3f edge1;
  Vec3f edge2;
  Vec3f geometric_normal;       // unit; zero for degenerate triangles, which no ray hits
  Vec3f shading_normal;         // unit; used if has_one_normal
  float size = 0;               // largest absolute coordinate of the corners
  int material = 0;             // of the mesh
  bool has_one_normal = false;  // the three vertex normals are equal
};

struct TriangleMesh {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  std::vector<Vec2f> uvs;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<int> materials;                 // per triangle
  std::vector<TriangleCache> triangle_cache;  // per triangle
  std::vector<Vec2f> second_uvs{};            // as many as uvs, or none
  /// Positions in double of a mesh that is much larger than all else, whose corners in floats are too coarse
  /// for the scene on it. Empty otherwise.
  std::vector<Vec3d> exact_positions{};
  /// At the end of the frame, of a mesh that changes its shape; else empty.
  std::vector<Vec3f> end_positions{};
  std::vector<Vec3f> end_normals{};
};

/// One of the two sets of texture coordinates. The loader lets no texture ask for one that is not there.
inline const std::vector<Vec2f>& uvs_of(const TriangleMesh& mesh, int set) {
  return set == 0 ? mesh.uvs : mesh.second_uvs;
}

struct SphereSurface {
  Vec3d centre;
  double radius = 0;
  int material = 0;
};

enum class ObjectKind { WorldMesh, InstancedMesh, MovingMesh, Light, Sphere, Solid, PluginShape };

/// Spheres, other shapes by their formula and those of plug-ins: they have no triangles.
constexpr bool is_analytic(ObjectKind kind) { return kind >= ObjectKind::Sphere; }

/// One object that rays can hit: a mesh with its vertices in world space, an instance of a mesh in the space
/// of the mesh, one of a mesh that moves or changes its shape within the frame, a light, a sphere, another
/// shape by its formula, or a shape of a plug-in.
struct RenderObject {
  ObjectKind kind = ObjectKind::WorldMesh;
  std::size_t mesh = 0;            // index into World::meshes
  std::size_t light = 0;           // index into World::lights
  std::size_t sphere = 0;          // index into World::spheres
  std::size_t solid = 0;           // index into World::solids
  std::size_t plugin_shape = 0;    // index into World::plugin_shapes
  Affine to_world;                 // InstancedMesh, and MovingMesh at the start of the frame
  Affine end_to_world;             // MovingMesh only, at its end
  Affine normal_to_world;          // InstancedMesh only
  std::vector<int> material_of;    // material of the mesh -> material shown (remap list applied)
  std::vector<int> mirror_planes;  // per triangle: index into World::mirror_planes or -1; empty without any
  std::vector<int> emitters;       // per triangle: index into World::emitters or -1; empty without any
};

}  // namespace orbs::tracer
