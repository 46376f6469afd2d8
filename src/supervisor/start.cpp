#include "supervisor/start.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <linux/keyctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace orbs::supervisor {

namespace {

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> out;
  for (auto& text : texts) out.push_back(text.data());
  out.push_back(nullptr);
  return out;
}

void limit_file_size(const ProcessLimits& limits) {
  rlimit size{};
  if (!limits.output_bytes || ::getrlimit(RLIMIT_FSIZE, &size) != 0) return;
  size.rlim_cur = size.rlim_max = std::min<rlim_t>(*limits.output_bytes, size.rlim_max);
  ::setrlimit(RLIMIT_FSIZE, &size);
}

// When the machine runs out of memory, the kernel shall kill the renderer and not the harness.
void prefer_for_oom_kill() {
  const int file = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
  if (file < 0) return;
  const auto written = ::write(file, "1000", 4);
  static_cast<void>(written);  // only a preference: without it the kernel chooses by size alone
  ::close(file);
}

void restore_signals() {
  for (int signal = 1; signal < NSIG; ++signal) std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

// The keys of a session (keyrings(7)) go on to all its children, in any namespace: tokens of network disks,
// passwords of disks. Where the kernel has none, or a container refuses the call, none can be read either.
void leave_keyring() { ::syscall(SYS_keyctl, KEYCTL_JOIN_SESSION_KEYRING, nullptr); }

// In the child. Returns only when something fails, with errno.
void exec_command(const Command& command) {
  ::setsid();
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // when the supervisor is killed
  restore_signals();
  limit_file_size(command.limits);
  prefer_for_oom_kill();
  if (command.has_own_keyring) leave_keyring();
  if (!command.folder.empty() && ::chdir(command.folder.c_str()) != 0) return;
  const int nothing = ::open("/dev/null", O_RDONLY);
  if (nothing < 0 || ::dup2(nothing, STDIN_FILENO) < 0) return;
  if (nothing > STDERR_FILENO) ::close(nothing);
  auto argv = command.argv;
  ::execve(command.argv.front().c_str(), pointers(argv).data(), environ);
}

}  // namespace

Started start(const Command& command) {
  std::array<int, 2> failure{-1, -1};
  if (::pipe2(failure.data(), O_CLOEXEC) != 0) return {0, errno};
  const pid_t pid = ::fork();
  if (pid == 0) {
    exec_command(command);
    const int error = errno;
    const auto written = ::write(failure[1], &error, sizeof error);
    static_cast<void>(written);
    ::_exit(127);
  }
  Started started{pid, pid < 0 ? errno : 0};
  ::close(failure[1]);
  // When exec succeeds, the pipe closes without any bytes.
  int error = 0;
  if (pid > 0 && ::read(failure[0], &error, sizeof error) == sizeof error) {
    started.error = error;
    ::waitpid(pid, nullptr, 0);
  }
  ::close(failure[0]);
  return started;
}

}  // namespace orbs::supervisor
