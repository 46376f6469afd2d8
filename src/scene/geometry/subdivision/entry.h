#pragma once

#include "json/writer.h"
#include "scene/geometry/mesh_file.h"
#include "scene/geometry/subdivision/subdivision_surface.h"
#include "scene/load/entry.h"

namespace orbs::scene {

/// The mesh entry `in` that has a "subdivision", tessellated; its origin is taken from its cage too. Its
/// materials are left to the caller. InputError at the key that is wrong.
MeshFile load_subdivision(json::ObjectReader& in, SceneBudget& left);

/// The value of the key "subdivision" of a mesh.
void write_subdivision(json::Writer& out, const SubdivisionSurface& surface);

}  // namespace orbs::scene
