#pragma once

#include "scene/scene.h"

#include <string>

namespace orbs::tracer {

/// Why this build cannot draw the scene, one sentence that names the thing in it; "" when it can. A picture
/// without what the scene calls for would be wrong, so there is none.
std::string lacking_for(const scene::Scene& scene);

}  // namespace orbs::tracer
