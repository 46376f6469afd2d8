#pragma once

#include "base/process_limits.h"
#include "supervisor/supervise.h"

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

namespace orbs::adapters {

/// A program to run as a child process.
struct ProcessRequest {
  std::vector<std::string> argv;         // argv[0] is the file that is started, as an absolute path
  std::filesystem::path folder;          // working directory, whose size is limited; "": ours, not limited
  std::vector<std::string> environment;  // NAME=value, nothing else is passed on
  std::filesystem::path log;  // stdout and stderr, written as they arrive; "" keeps them in memory only
  ProcessLimits limits;
  // For the supervisor to report once the limits or an interrupt have ended the process. It may need as long
  // as it waits for what cannot be killed; then we kill it and all that it started.
  double answer_seconds = supervisor::kGiveUp_seconds + 5;
  const std::atomic<bool>* stop = nullptr;  // when it becomes true, the process is ended
};

}  // namespace orbs::adapters
