#pragma once

#include "adapters/mitsuba/colours.h"

#include <string>

namespace orbs::adapters::mitsuba {

/// `<bsdf id="material<i>">`. An emissive material reflects nothing; what it emits stands with its shapes.
std::string bsdf_text(const Colours& colours, int material, const std::string& stem);

}  // namespace orbs::adapters::mitsuba
