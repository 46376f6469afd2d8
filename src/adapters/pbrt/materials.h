#pragma once

#include "adapters/pbrt/colours.h"

#include <string>

namespace orbs::adapters::pbrt {

/// Declares the named material "material<i>". An emissive one reflects nothing; what it emits stands with its
/// shapes.
std::string material_text(const Colours& colours, int material, const std::string& stem);

}  // namespace orbs::adapters::pbrt
