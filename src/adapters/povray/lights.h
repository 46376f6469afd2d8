#pragma once

#include "adapters/povray/settings.h"
#include "scene/scene.h"

#include <string>

namespace orbs::adapters::povray {

/// A light, and its visible body: the side that emits is seen by the camera and in mirrors but is no source
/// of radiosity (the light source already counts) and throws no shadow; the black side behind it is an
/// obstacle to all rays.
std::string light_text(const scene::Scene& scene, const scene::Light& light, const PovraySettings& settings);

/// What rays see that meet nothing: a colour, or the image that environment_file names. A sphere that the
/// camera does not see where it is to be black.
std::string environment_text(const scene::Scene& scene, const std::string& stem);
std::string environment_file(const std::string& stem);

/// Why the light cannot be written, "" when it can.
std::string light_limit(const scene::Light& light, const std::string& display_name);

}  // namespace orbs::adapters::povray
