#pragma once

#include "command_line/command.h"

#include <string>

namespace orbs::cli {

/// What is wrong with the command line, in the words of our own messages: what was expected and found, the
/// nearest option, and where help is.
std::string parse_complaint(const command_line::Parsed& parsed, const command_line::Command& program);

}  // namespace orbs::cli
