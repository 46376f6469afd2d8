#pragma once

#include "image/image.h"
#include "scene/scene.h"

#include <string>

namespace orbs::peers {

/// Lowers the scene, runs a renderer of our configuration.json that starts Blender in a folder of its own,
/// reads the image. std::runtime_error with a clear reason when Blender is not installed or gives no image.
image::Image render_with_cycles(const scene::Scene& scene,
                                const std::string& name,
                                int spp,
                                const std::string& renderer = "cycles");

}  // namespace orbs::peers
