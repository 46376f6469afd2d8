#pragma once

#include "registry/case.h"

#include <filesystem>
#include <vector>

/// What only all cases of a suite together tell. InputErrors with the file of the case.
namespace orbs::registry {

/// One scene may serve several cases; it is rendered once, so it must be the same scene everywhere.
void refuse_conflicts(const std::vector<Case>& cases);

/// After symbolic links: a case must not reach into what is none of the suite's business.
void refuse_outside(const std::filesystem::path& file,
                    const std::filesystem::path& folder,
                    const Case& one_case);

/// A scene that is judged by the reference of another one names a scene that has its own reference.
void check_references(const std::vector<Case>& cases);

}  // namespace orbs::registry
