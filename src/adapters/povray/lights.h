#pragma once

#include "adapters/povray/povray.h"

#include <string>

namespace orbs::adapters::povray {

/// Lights, and the body that is seen of each: the side that emits shines on the camera and on mirrors but is
/// no source of radiosity (the light source already counts) and throws no shadow; the black side behind it is
/// an obstacle to all rays.
std::string light_text(const scene::Scene& scene, const scene::Light& light, const PovraySettings& settings);

/// Why the light cannot be written, "" when it can.
std::string light_limit(const scene::Light& light, const std::string& called);

}  // namespace orbs::adapters::povray
