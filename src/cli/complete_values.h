#pragma once

#include "cli/program.h"
#include "command_line/command.h"

#include <string>
#include <vector>

/// What the values of options may be, for the shell's completion.
namespace orbs::cli {

/// The word for the values of an option, "scenes"; "" where they are files or free text.
std::string value_kind(const command_line::OptionText& option);

/// All words of value_kind.
const std::vector<std::string>& value_kinds();

/// The values of a kind, as the configuration that a command would read has them. None where it cannot be
/// read: the command itself then says why.
std::vector<std::string> values_of_kind(const std::string& kind, const Program& program);

}  // namespace orbs::cli
