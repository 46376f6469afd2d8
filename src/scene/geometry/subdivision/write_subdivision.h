#pragma once

#include "json/writer.h"
#include "scene/geometry/subdivision/subdivision_surface.h"

namespace orbs::scene {

/// The value of the key "subdivision" of a mesh.
void write_subdivision(json::Writer& out, const SubdivisionSurface& surface);

}  // namespace orbs::scene
