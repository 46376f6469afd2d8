#pragma once

#include "json/object_reader.h"
#include "scene/scene.h"

#include <string>

namespace orbs::scene {

/// The camera of a scene file by its name among "cameras", "" for that of "camera". Where no camera is
/// chosen, the file must have one without a name. InputError at the key that is wrong.
Camera load_cameras(json::ObjectReader& in, const std::string& chosen);

}  // namespace orbs::scene
