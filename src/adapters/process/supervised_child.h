#pragma once

#include "base/process_limits.h"
#include "supervisor/supervise.h"

#include <array>
#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace orbs::adapters {

/// A program to run as a child process.
struct ProcessRequest {
  std::vector<std::string> argv;         // argv[0] is the file that is started, as an absolute path
  std::filesystem::path folder;          // working directory, whose size is limited; "": ours, not limited
  std::vector<std::string> environment;  // NAME=value, nothing else is passed on
  std::filesystem::path log;  // stdout and stderr, written as they arrive; "" keeps them in memory only
  ProcessLimits limits;
  bool has_own_keyring = false;  // sees no keys that the kernel keeps for our session
  // For the supervisor to report once the limits or an interrupt have ended the process. It may need as long
  // as it waits for what cannot be killed; then we kill it and all that it started.
  double answer_seconds = supervisor::kGiveUp_seconds + 5;
  const std::atomic<bool>* stop = nullptr;  // when it becomes true, the process is ended
};

/// The two ends of a pipe that no child inherits except by dup2. Both descriptors are above 3: the child uses
/// 0 to 3.
class Pipe {
 public:
  Pipe();
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  bool is_open() const { return ends_[0] >= 0 && ends_[1] >= 0; }
  int read_end() const { return ends_[0]; }
  int write_end() const { return ends_[1]; }
  void close_read_end();
  void close_write_end();

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// The pipes between us and one supervisor.
struct Pipes {
  Pipe control;  // to the supervisor: it ends the command when this closes
  Pipe output;   // of the command
  Pipe report;   // of the supervisor
};

/// The command line of the supervisor that runs `request`. orbs-supervisor lies beside the running program,
/// or, as for test programs, in a folder above.
std::vector<std::string> supervisor_command(const ProcessRequest& request);

/// Starts that supervisor in its own session and closes its ends of the pipes here. Returns errno when
/// it cannot be started, else 0. Makes us a child subreaper (prctl(2)): what a supervisor leaves behind when
/// it is killed becomes our child.
int start_supervisor(const ProcessRequest& request, Pipes& pipes, pid_t& pid);

/// Waits for the supervisor's end; returns its status as waitpid(2) does.
int reap_supervisor(pid_t pid);

/// For a supervisor that does not answer, stopped or hanging in the kernel: kills it and all below it. Waits
/// for its end, but not for ever.
void kill_supervisor(pid_t pid);

/// Kills and reaps all that supervisors left behind that are gone: our children in another session than ours
/// that are no supervisors, and all below them. Waits for their end, but not for ever.
void kill_orphans();

}  // namespace orbs::adapters
