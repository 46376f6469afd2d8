#pragma once

#include "cli/action.h"

#include <span>

namespace CLI {  // NOLINT(readability-identifier-naming): the name is the library's
class App;
}

namespace orbs::cli {

/// A command of orbs. `add` gives it its options, and the action that runs when the command is chosen.
struct Command {
  const char* name;
  const char* group;  // the heading in orbs --help
  const char* summary;
  void (*add)(CLI::App& command, const Program& program, Action& action);
};

/// All commands in the order of orbs --help, those of one group in a row.
std::span<const Command> commands();

}  // namespace orbs::cli
