#pragma once

#include "registry/case.h"
#include "registry/configuration.h"

#include <string>
#include <vector>

namespace orbs::registry {

/// All cases of a suite in the order of the specification. Every folder below suite.cases must hold a
/// case.json. InputError also when two cases give one scene name to different files, samples or references,
/// when the reference of a scene is that of a scene which is not there or has none itself, or when there is
/// no case at all.
std::vector<Case> load_cases(const Suite& suite);

/// The scenes of the suite whose names match (registry/filters.h), each once, in its order. InputError for a
/// pattern that matches none.
std::vector<CaseScene> scenes_of(const Suite& suite, const std::string& patterns);

}  // namespace orbs::registry
