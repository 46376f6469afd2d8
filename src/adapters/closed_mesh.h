#pragma once

#include "scene/scene.h"

namespace orbs::adapters {

/// Mitsuba's area emitter shines from one side only. On a closed mesh nobody outside it can tell; this asks
/// what it takes.
///
/// Every edge is shared by triangles that run along it in opposite directions, equally many each way.
/// Corners count as one where they differ by less than a millionth of the mesh's size.
bool is_closed(const scene::Mesh& mesh);

/// The winding of a closed mesh gives normals that point outwards (positive signed volume).
bool is_wound_outwards(const scene::Mesh& mesh);

/// `point`, in the mesh's own frame, lies in a closed mesh: the triangles cover all directions from it.
bool encloses(const scene::Mesh& mesh, Vec3d point);

}  // namespace orbs::adapters
