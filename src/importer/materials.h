#pragma once

#include "importer/import.h"

#include <string>

namespace orbs::importer {

/// The index of the scene's material that shows glTF's material, -1 its default one, in this way; it is made
/// where there is none yet.
int material_for(Import& import, int index, const Shown& shown);

}  // namespace orbs::importer
