#pragma once

#include "registry/case.h"
#include "registry/configuration.h"
#include "registry/run_settings.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

/// What only all cases of a suite together tell. InputErrors with the file of the case.

namespace orbs::registry {

/// All cases of a suite in the order of the specification. Every folder below suite.cases must hold a
/// case.json. InputError also when two cases give one scene name to different files, samples or references,
/// when the reference of a scene is that of a scene which is not there or has none itself, or when there is
/// no case at all.
std::vector<Case> load_cases(const Suite& suite);

/// The scenes of the suite whose names match (registry/filters.h), each once, in its order. InputError for a
/// pattern that matches none.
std::vector<CaseScene> scenes_of(const Suite& suite, const std::string& patterns);

/// One scene may serve several cases; it is rendered once, so it must be the same scene everywhere.
void refuse_conflicts(const std::vector<Case>& cases);

/// After symbolic links: a case must not reach into what is none of the suite's business.
void refuse_outside(const std::filesystem::path& file,
                    const std::filesystem::path& folder,
                    const Case& one_case);

/// A scene that is judged by the reference of another one names a scene that has its own reference.
void check_references(const std::vector<Case>& cases);

/// The cases that the settings choose, each with the targets that they choose. Scenes from which only a
/// chosen difference is made stay in the case. InputError when a filter matches nothing, or all of them
/// together leave no scene.
std::vector<Case> choose_cases(const std::vector<Case>& all, const RunSettings& settings);

/// The case with these targets alone, and the scenes that its chosen differences are made from.
Case with_targets(const Case& whole, const std::set<std::string>& chosen);

}  // namespace orbs::registry
