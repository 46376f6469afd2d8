#pragma once

#include "importer/import.h"
#include "importer/nodes.h"

#include <vector>

namespace orbs::importer {

/// Adds the lights of KHR_lights_punctual. Candela and lux are taken for W/sr and W/m2, as the radiance of
/// what emits is taken for nits: the three have one scale in both formats.
void add_lights(Import& import, const std::vector<PlacedNode>& nodes);

/// Where nothing shines: light from afar, from the upper left of what the camera sees, and an even sky.
void add_default_light(Import& import);

}  // namespace orbs::importer
