#pragma once

#include "supervisor/limits.h"
#include "supervisor/report.h"

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

/// Programs as child processes: started without a shell, watched, measured and ended with everything that
/// they started, each by an orbs-supervisor of its own.
namespace orbs::adapters {

struct ProcessRequest {
  std::vector<std::string> argv;         // argv[0] is the file that is started, as an absolute path
  std::filesystem::path folder;          // working directory, whose size is limited; "" for ours, not limited
  std::vector<std::string> environment;  // NAME=value, nothing else is passed on
  std::filesystem::path log;             // stdout and stderr, as they come; "" keeps them in memory only
  supervisor::Limits limits;
  const std::atomic<bool>* stop = nullptr;  // set by somebody: end the process now
};

struct ProcessResult : supervisor::Report {
  std::string output;  // stdout and stderr, capped as the log is
  std::string lost;    // how its supervisor ended when that left no report; "" when it did
};

/// Runs one program to its end. Never throws for what the program does; WriteError when the log cannot be
/// written, after the program has been ended.
ProcessResult run_process(const ProcessRequest& request);

/// "SIGSEGV" for 11, "signal 99" for one without a name.
std::string signal_name(int signal);

}  // namespace orbs::adapters
