#pragma once

#include "cli/action.h"
#include "command_line/command.h"

#include <span>

namespace orbs::cli {

/// A command of orbs. `add` gives it its options, and the action that runs when the command is chosen.
struct Command {
  const char* name;
  const char* group;  // the heading in orbs --help
  const char* summary;
  void (*add)(const command_line::Command& command, const Program& program, Action& action);
};

/// All commands in the order of orbs --help, those of one group in a row.
std::span<const Command> commands();

}  // namespace orbs::cli
