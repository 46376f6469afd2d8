#pragma once

#include "importer/import.h"
#include "importer/nodes.h"

#include <optional>
#include <vector>

namespace orbs::importer {

/// Adds the lights of KHR_lights_punctual. Candela and lux are taken for W/sr and W/m2, as the radiance of
/// what emits is taken for nits: the three have one scale in both formats.
void add_lights(Import& import, const std::vector<PlacedNode>& nodes);

/// An even sky of that radiance. Without one, where nothing shines: light from afar, from the upper left of
/// what the camera sees, and a sky.
void add_sky(Import& import, const std::optional<double>& radiance);

}  // namespace orbs::importer
