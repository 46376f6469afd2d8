#pragma once

#include "scene/geometry/mesh.h"

#include <string>

namespace orbs::adapters::hydra {

/// The bytes of the mesh in HydraCore3's format VSGF: a header, then positions, normals, tangents, texture
/// coordinates, the corners of the triangles, and a material for each triangle. Vertices stay as they are;
/// the materials are those of the mesh plus `first_material`.
std::string vsgf_bytes(const scene::Mesh& mesh, int first_material = 0);

}  // namespace orbs::adapters::hydra
