#pragma once

#include "adapters/mitsuba/colours.h"

#include <string>

namespace orbs::adapters::mitsuba {

/// Name of the picture of a textured material beside a scene file of this stem, its colour multiplied in.
std::string picture_name(int material, const std::string& stem);

/// `<bsdf id="material<i>">`. An emissive material reflects nothing; what it emits stands with its shapes.
std::string bsdf_text(const Colours& colours, int material, const std::string& stem);

}  // namespace orbs::adapters::mitsuba
