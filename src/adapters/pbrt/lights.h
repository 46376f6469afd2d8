#pragma once

#include "adapters/pbrt/colours.h"

#include <string>

namespace orbs::adapters::pbrt {

/// A light as a black shape that emits towards its normal.
std::string light_text(const Colours& colours, const scene::Light& light);

}  // namespace orbs::adapters::pbrt
