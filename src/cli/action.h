#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace orbs::cli {

/// What every command knows of the program that it belongs to.
struct Program {
  std::string version;
  std::filesystem::path folder;  // the folder of the executable: {build}
  std::vector<std::string> command_line;
};

/// The work of the chosen command, called after all options are read. Returns the exit status.
using Action = std::function<int()>;

}  // namespace orbs::cli
