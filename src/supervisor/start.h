#pragma once

#include "supervisor/limits.h"

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace orbs::supervisor {

/// What is to be run, and where.
struct Order {
  std::vector<std::string> argv;  // argv[0] is the file that is started
  std::filesystem::path folder;   // working directory, and the one whose size is limited; "" for ours
  Limits limits;
};

struct Started {
  pid_t pid = 0;
  int error = 0;  // errno when it could not be started
};

/// Starts the command in a session of its own, with no input, our environment, standard output and errors.
Started start(const Order& order);

}  // namespace orbs::supervisor
