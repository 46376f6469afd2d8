#pragma once

#include <string>
#include <vector>

namespace orbs {

/// Quotes `words` as a command line that a POSIX shell splits into the same words.
std::string shell_text(const std::vector<std::string>& words);

/// A line for a POSIX shell that runs `argv` with exactly the variables NAME=value of `environment`.
std::string shell_command(std::vector<std::string> environment, const std::vector<std::string>& argv);

}  // namespace orbs
