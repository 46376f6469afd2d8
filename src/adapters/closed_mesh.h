#pragma once

#include "scene/scene.h"

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

}  // namespace orbs::adapters
