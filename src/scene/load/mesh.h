#pragma once

#include "scene/geometry/mesh_file.h"
#include "scene/load/entry.h"

namespace orbs::scene {

/// One entry of "meshes", its materials those of the scene; paths in it are relative to `folders.own`.
/// InputError at the key that is wrong.
MeshFile load_mesh(json::ObjectReader in,
                   const DataFolders& folders,
                   const Names& materials,
                   SceneBudget& left);

/// The complaint about a mesh that cannot be drawn as given ("" when it can): array lengths, indices beyond
/// the vertices, numbers that are not finite, normals of length zero.
std::string mesh_problem(const Mesh& mesh);

}  // namespace orbs::scene
