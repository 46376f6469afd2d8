#pragma once

#include "command_line/command.h"

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace orbs::cli {

/// What every command knows of the program that it belongs to.
struct Program {
  std::string version;
  std::filesystem::path folder;  // the folder of the executable: {build}
  std::vector<std::string> command_line;
};

/// How the program was called, for commands that are shown and can be pasted: "orbs" where the shell had
/// found it, else its path from the working folder.
std::string called_as(const std::vector<std::string>& command_line);

/// The work of the chosen command, called after all options are read. Returns the exit status.
using Action = std::function<int()>;

/// Runs the program. Never throws. Returns the exit status: 0 if all is as expected, 1 if something failed,
/// 2 if it could not run, 3 after a bug of orbs itself.
int run_program(int argc, char** argv, const std::string& version);

/// Adds all commands of orbs. `program` and `action` must live as long as `all`.
void add_commands(const command_line::Command& all, const Program& program, Action& action);

/// A command of orbs. `add` gives it its options, and the action that runs when the command is chosen.
struct Command {
  const char* name;
  const char* group;  // the heading in orbs --help
  const char* summary;
  void (*add)(const command_line::Command& command, const Program& program, Action& action);
};

/// All commands in the order of orbs --help, those of one group in a row.
std::span<const Command> commands();

/// What is wrong with the command line, in the words of our own messages: what was expected and found, the
/// nearest option, and where help is.
std::string parse_complaint(const command_line::Parsed& parsed, const command_line::Command& program);

}  // namespace orbs::cli
