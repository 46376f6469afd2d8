#pragma once

#include "adapters/pbrt/colours.h"

#include <string>

namespace orbs::adapters::pbrt {

/// A light as a black shape that emits towards its normal, or as a light source without an area, whose IES
/// profile is the image of the name `profile` (profile_image.h).
std::string light_text(const Colours& colours, const scene::Light& light, const std::string& profile);

/// Why the light cannot be written, "" when it can.
std::string light_limit(const scene::Light& light, const std::string& display_name);

}  // namespace orbs::adapters::pbrt
