#include "adapters/process.h"

#include "adapters/interrupt.h"
#include "adapters/output_log.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <string_view>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace orbs::adapters {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// The two ends of a pipe that no other child inherits.
struct Pipe {
  int read_end = -1;
  int write_end = -1;

  Pipe() {
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
    read_end = ends[0];
    write_end = ends[1];
  }
  ~Pipe() {
    if (read_end >= 0) ::close(read_end);
    close_write_end();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_write_end() {
    if (write_end >= 0) ::close(write_end);
    write_end = -1;
  }
};

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> out;
  for (auto& text : texts) out.push_back(text.data());
  out.push_back(nullptr);
  return out;
}

// posix_spawn, which reports a failed exec to the caller, and is safe in a program with threads.
int spawn(const ProcessRequest& request, int output, pid_t& pid) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
  if (!request.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, request.folder.c_str());
  // A session of its own: Ctrl-C in the terminal reaches only us, and the group can be signalled as a whole.
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  sigset_t signals;
  sigfillset(&signals);
  posix_spawnattr_setsigdefault(&attributes, &signals);
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&attributes, &signals);
  auto argv = request.argv;
  auto environment = request.environment;
  const int error = posix_spawn(&pid, argv.at(0).c_str(), &actions, &attributes, pointers(argv).data(),
                                pointers(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

// Reads what is there, waiting for it at most `most_ms`. False once nobody holds the other end.
bool drain(int file, OutputLog& log, int most_ms) {
  pollfd waiting{file, POLLIN, 0};
  if (::poll(&waiting, 1, most_ms) <= 0) return true;
  std::array<char, 65536> buffer{};
  const auto count = ::read(file, buffer.data(), buffer.size());
  if (count > 0) log.append({buffer.data(), static_cast<std::size_t>(count)});
  return count > 0 || (count < 0 && errno == EINTR);
}

// Looks without reaping: the process id, and with it the group's, stays taken until the group is gone.
bool has_ended(pid_t pid) {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(pid), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == pid;
}

// VmHWM of a running process, 0 when there is none to be had.
std::size_t peak_rss_now(pid_t pid) {
  std::ifstream status(fmt::format("/proc/{}/status", pid));
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:"))
      return static_cast<std::size_t>(to_integer(trim(line.substr(6, line.find("kB") - 6))).value_or(0)) *
             1024;
  return 0;
}

std::size_t own_peak_rss() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

double to_seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// A child's ru_maxrss starts at the peak of the parent that it was spawned from (exec folds the old memory
// map in, see exec_mmap in Linux' fs/exec.c), so below our own peak only what was seen while it ran can be
// trusted.
void reap(pid_t pid, std::size_t seen_rss, std::size_t parent_rss, ProcessResult& result) {
  int status = 0;
  rusage usage{};
  while (::wait4(pid, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  result.user_seconds = to_seconds(usage.ru_utime);
  result.system_seconds = to_seconds(usage.ru_stime);
  const auto reported = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  result.peak_rss_bytes = reported > parent_rss ? reported : seen_rss;
}

// Watches the process to its end, and ends it and its whole group where that is due.
void watch(
    pid_t pid, const Pipe& pipe, const ProcessRequest& request, OutputLog& log, ProcessResult& result) {
  const GroupAtRisk at_risk(pid);
  constexpr int kLookEvery_ms = 20;
  const auto start = Clock::now();
  const std::size_t parent_rss = own_peak_rss();
  std::size_t seen_rss = 0;
  double terminated_at = -1;  // seconds; < 0: not yet
  for (bool open = true; !has_ended(pid);) {
    if (open) {
      open = drain(pipe.read_end, log, kLookEvery_ms);
    } else {
      ::poll(nullptr, 0, 1);
    }
    seen_rss = std::max(seen_rss, peak_rss_now(pid));
    const double elapsed = seconds_since(start);
    if (terminated_at < 0) {
      result.timed_out = elapsed >= request.time_limit_seconds;
      result.stopped = !result.timed_out && request.stop != nullptr && request.stop->load();
      if (!result.timed_out && !result.stopped) continue;
      terminated_at = elapsed;
      ::kill(-pid, SIGTERM);
    } else if (elapsed >= terminated_at + request.grace_seconds) {
      ::kill(-pid, SIGKILL);
    }
  }
  result.wall_seconds = seconds_since(start);
  ::kill(-pid, SIGKILL);  // what it left behind
  reap(pid, seen_rss, parent_rss, result);
  while (drain(pipe.read_end, log, 0)) {
    pollfd waiting{pipe.read_end, POLLIN, 0};
    if (::poll(&waiting, 1, 0) <= 0)
      break;  // somebody outside the group holds the pipe; its words are not waited for
  }
}

}  // namespace

ProcessResult run_process(const ProcessRequest& request) {
  ProcessResult result;
  OutputLog log(request.log, request.most_log_bytes);
  Pipe pipe;
  pid_t pid = 0;
  const int error = pipe.read_end < 0 ? errno : spawn(request, pipe.write_end, pid);
  pipe.close_write_end();
  if (error != 0) {
    result.start_error = std::strerror(error);
    log.append(fmt::format("[orbs: {}: {}]\n", request.argv.at(0), result.start_error));
  } else {
    watch(pid, pipe, request, log, result);
  }
  result.output = log.finish();
  return result;
}

std::string signal_name(int signal) {
  const char* name = ::sigabbrev_np(signal);
  return name == nullptr ? fmt::format("signal {}", signal) : fmt::format("SIG{}", name);
}

}  // namespace orbs::adapters
