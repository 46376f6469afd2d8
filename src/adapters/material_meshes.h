#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace orbs::adapters {

/// Mitsuba's area emitter shines from one side only, which cannot be told from outside a closed mesh. These
/// functions check that condition.
///
/// A mesh is closed when every edge is shared by triangles that run along it in opposite directions, equally
/// many each way. Corners count as one where they differ by less than a millionth of the mesh's size.
bool is_closed(const scene::Mesh& mesh);

/// Whether the winding of a closed mesh gives normals that point outwards (positive signed volume).
bool is_wound_outwards(const scene::Mesh& mesh);

/// Whether `point`, in the mesh's own frame, lies inside a closed mesh: the triangles then cover all
/// directions from it.
bool encloses(const scene::Mesh& mesh, Vec3d point);

/// A mesh in one material and the places where it stands.
struct MaterialMesh {
  scene::Mesh mesh;  // triangles that have area
  int material = 0;
  std::vector<Mat4> places;  // at least one
  /// Where they have normal maps and are split by their frames: v grows to the other side than normal x u.
  bool is_mirrored = false;
};

/// What a renderer has of texture coordinates: one set for each mesh, or both of ours.
enum class UvSets { One, Both };

/// The visible surfaces of a scene for renderers that give one material to a whole mesh and apply no texture
/// matrices: remap lists are resolved, and texture matrices are applied to the coordinates. Instances with
/// the same mesh and materials share a MaterialMesh. Where there is one set of texture coordinates, it is the
/// one that the textures of the material are looked up at (uv_set_limit).
std::vector<MaterialMesh> material_meshes(const scene::Scene& scene, UvSets uv_sets = UvSets::One);

/// Those with a normal map split, so that in each of them v grows to one side, of which `is_mirrored` tells:
/// for renderers that take normal x u for the direction of v.
std::vector<MaterialMesh> split_by_frames(const scene::Scene& scene, const std::vector<MaterialMesh>& meshes);

/// Why a renderer with one set of texture coordinates cannot draw the material; "" when it can.
std::string uv_set_limit(const scene::Scene& scene, int material, const char* renderer);

}  // namespace orbs::adapters
