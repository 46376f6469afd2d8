#pragma once

#include "scene/scene.h"

namespace orbs::scene {

/// What becomes of the normals that a mesh has.
enum class GivenNormals { Replace, Keep };

/// Gives the mesh normals: all, or where a corner has none that is finite and not zero. The normal of a
/// triangle's corner is the sum of those of all triangles at the same position whose planes are turned
/// against its own by at most `crease_deg`, each weighted by its angle there, so that the result does not
/// depend on how a surface is cut into triangles (Thürmer, Wüthrich 1998, Computing Vertex Normals from
/// Polygonal Facets). Positions are the same where they are equal to the bit. Vertices whose corners differ
/// are split. Triangles without area, which nothing shows, have the normal (0, 1, 0) where nothing else is.
/// Triangles wound counter-clockwise face outwards. All indices must be in range.
void compute_normals(Mesh& mesh, double crease_deg, GivenNormals given = GivenNormals::Replace);

}  // namespace orbs::scene
