#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace orbs::cli {

struct Program {
  std::string version;
  std::filesystem::path folder;  // the folder of the executable: {build}
  std::vector<std::string> command_line;
};

/// The work of the chosen command, called after all options are read. Returns the exit status.
using Action = std::function<int()>;

/// Runs the program. Never throws. Returns the exit status: 0 if all is as expected, 1 if something failed,
/// 2 if it could not run, 3 after a bug of orbs itself.
int run_program(int argc, char** argv, const std::string& version);

}  // namespace orbs::cli
