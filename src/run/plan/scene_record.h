#pragma once

#include "results/record.h"
#include "scene/scene.h"

#include <string>

namespace orbs::run {

/// The effects that the scene calls for, as results and `orbs effects` show them.
results::SceneRecord scene_record(const std::string& name, const scene::Scene& scene);

}  // namespace orbs::run
