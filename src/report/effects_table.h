#pragma once

#include "results/record.h"

#include <string>
#include <vector>

namespace orbs::report {

/// For people: each scene with its transport, below it one line for each effect with the first thing that
/// calls for it and how many others do, then what looks like an effect and is none.
std::string effects_text(const std::vector<results::SceneRecord>& scenes);

}  // namespace orbs::report
