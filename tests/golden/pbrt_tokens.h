#pragma once

#include <string>
#include <vector>

namespace orbs::tests {

/// The words of a pbrt scene; those in quotes keep the first quote as a mark. Throws std::runtime_error for a
/// string without end.
std::vector<std::string> pbrt_tokens(const std::string& text);

}  // namespace orbs::tests
