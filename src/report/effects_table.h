#pragma once

#include "results/record.h"

#include <string>
#include <vector>

namespace orbs::report {

/// A table for a terminal: each scene with its transport; below it one line for each effect with the first
/// part of the scene that calls for it and the number of others, then what looks like an effect and is none.
std::string effects_text(const std::vector<results::SceneRecord>& scenes);

}  // namespace orbs::report
