#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Programs as child processes: started without a shell, in a group of their own, watched, measured, and
/// ended with everything that they started.
namespace orbs::adapters {

struct ProcessRequest {
  std::vector<std::string> argv;         // argv[0] is the file that is started, as an absolute path
  std::filesystem::path folder;          // working directory; "" for ours
  std::vector<std::string> environment;  // NAME=value, nothing else is passed on
  std::filesystem::path log;             // stdout and stderr, as they come; "" keeps them in memory only
  double time_limit_seconds = 600;
  double grace_seconds = 2;                 // between TERM and KILL
  std::size_t most_log_bytes = 1 << 20;     // what is beyond is left out of the middle
  const std::atomic<bool>* stop = nullptr;  // set by somebody: end the process now
};

struct ProcessResult {
  std::string start_error;  // why it could not be started; "" when it was
  bool timed_out = false;
  bool stopped = false;  // because of ProcessRequest::stop
  int exit_code = 0;     // when no signal ended it
  int signal = 0;        // that ended it; 0 for none
  double wall_seconds = 0;
  double user_seconds = 0;  // of the process and its children that it waited for
  double system_seconds = 0;
  std::size_t peak_rss_bytes = 0;  // of the largest single process among them
  std::string output;              // stdout and stderr, capped as the log is
};

/// Runs one program to its end. Never throws for what the program does; InputError only when the log cannot
/// be written.
ProcessResult run_process(const ProcessRequest& request);

/// "SIGSEGV" for 11, "signal 99" for one without a name.
std::string signal_name(int signal);

}  // namespace orbs::adapters
