#pragma once

#include "adapters/povray/povray.h"
#include "image/image_io.h"

#include <string>
#include <vector>

namespace orbs::peers {

/// POV-Ray writes half floats, which round by up to 2^-11 of the value.
inline constexpr double kHalf = 4.9e-4;

/// Writes the scene, starts POV-Ray in a folder of its own, reads the image. One ray through each pixel's
/// centre. std::runtime_error with a clear reason when POV-Ray is not installed or fails.
image::Image render_with_povray(const scene::Scene& scene,
                                const std::string& name,
                                const adapters::PovraySettings& settings = {},
                                const std::vector<std::string>& options = {"-A"});

}  // namespace orbs::peers
