#pragma once

#include "scene/load/spectra.h"
#include "scene/scene.h"

namespace orbs::scene {

/// One entry of "lights"; paths in it are relative to `folders.own`. InputError at the key that is wrong.
Light load_light(json::ObjectReader in, const DataFolders& folders, const SpectralData& spectra);

}  // namespace orbs::scene
