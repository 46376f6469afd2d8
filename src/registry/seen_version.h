#pragma once

#include "registry/expected.h"

#include <string>

namespace orbs::registry {

/// The range that holds this version alone, "=3.4.1" of "Blender 3.4.1"; without bounds where the text has no
/// number that stands by itself, as in the name of a commit.
VersionRange range_of_version(const std::string& version);

}  // namespace orbs::registry
