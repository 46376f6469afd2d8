#pragma once

#include "base/process_limits.h"

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace orbs::supervisor {

/// A command to run, where, and its limits.
struct Command {
  std::vector<std::string> argv;  // argv[0] is the file that is started
  std::filesystem::path folder;   // working directory, whose size is limited; "": ours, not limited
  ProcessLimits limits;
  bool has_own_keyring = false;  // a new session keyring in the place of ours
};

struct Started {
  pid_t pid = 0;
  int error = 0;  // errno when it could not be started
};

/// Starts the command in a new session, with no input, our environment, standard output and errors.
Started start(const Command& command);

}  // namespace orbs::supervisor
