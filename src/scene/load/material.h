#pragma once

#include "scene/load/spectra.h"
#include "scene/material.h"

namespace orbs::scene {

/// One entry of "materials". InputError at the key that is wrong.
Material load_material(json::ObjectReader in, const Names& textures, SpectralData& spectra);

}  // namespace orbs::scene
