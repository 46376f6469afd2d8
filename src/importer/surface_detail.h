#pragma once

#include "importer/import.h"

namespace orbs::importer {

/// Opacity and normals of a material of glTF. `emits`: what emits has neither, which the report then says.
scene::SurfaceDetail surface_detail(Import& import, int index, bool emits);

}  // namespace orbs::importer
