#pragma once

#include "results/record.h"
#include "scene/scene.h"

#include <string>

namespace orbs::runner {

/// What the scene calls for, as results and `orbs plan` show it.
results::SceneRecord scene_record(const std::string& name, const scene::Scene& scene);

}  // namespace orbs::runner
