#pragma once

#include "cli/action.h"
#include "command_line/command.h"

#include <string>

namespace orbs::cli {

/// Runs the program. Never throws. Returns the exit status: 0 if all is as expected, 1 if something failed,
/// 2 if it could not run, 3 after a bug of orbs itself.
int run_program(int argc, char** argv, const std::string& version);

/// Adds all commands of orbs. `program` and `action` must live as long as `all`.
void add_commands(const command_line::Command& all, const Program& program, Action& action);

}  // namespace orbs::cli
