#pragma once

#include <cstddef>
#include <string>

namespace orbs::scene {

/// "light 'key'", or "light 2" for the one at that place of the file when it has no name.
std::string called(const char* kind, const std::string& name, std::size_t place);

}  // namespace orbs::scene
