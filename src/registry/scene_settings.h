#pragma once

#include "registry/configuration.h"

namespace orbs::registry {

/// The entry with the exporter's settings that it has at the reduced size instead of its usual ones.
Renderer at_size(Renderer renderer, SizeDivisor size_divisor);

/// The entry with the exporter's settings that it has for the scene of that name, which stand above those of
/// the size.
Renderer for_scene(Renderer renderer, const std::string& scene);

}  // namespace orbs::registry
