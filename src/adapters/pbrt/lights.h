#pragma once

#include "scene/scene.h"

#include <string>

namespace orbs::adapters::pbrt {

/// A light as a black shape that emits towards its normal.
std::string light_text(const scene::Light& light);

}  // namespace orbs::adapters::pbrt
