#pragma once

#include <string>

namespace orbs::adapters {

/// A name for a comment of one line: characters that end a line or control a terminal become spaces.
std::string comment_text(const std::string& name);

}  // namespace orbs::adapters
