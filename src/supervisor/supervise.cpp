#include "supervisor/supervise.h"

#include "supervisor/descendants.h"
#include "supervisor/folder_size.h"
#include "supervisor/memory.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

namespace orbs::supervisor {

namespace {

using Clock = std::chrono::steady_clock;

// Reading /proc must not disturb the measurement: 0.15 % of one core at most, but at least two polls a
// second, since usage between two polls is not limited.
constexpr double kPollShare = 0.0015;
constexpr double kShortestWait_seconds = 0.01;
constexpr double kLongestWait_seconds = 0.5;

double to_seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// CPU time of each process of a job as it was last seen. The kernel adds the time of a process to that of
// the one that waits for it, and nobody has to: where SIGCHLD is ignored, it is lost (wait(2)). So the sum
// over all that were ever seen is a lower bound beside the kernel's own sum.
struct CpuWatch {
  std::map<std::pair<pid_t, long long>, double> own_seconds;  // by id and start

  void note(const std::vector<Descendant>& processes) {
    for (const auto& process : processes)
      own_seconds[{process.pid, process.started_ticks}] = process.own_cpu_seconds;
  }
  double seconds() const {
    double sum = 0;
    for (const auto& [process, own] : own_seconds) sum += own;
    return sum;
  }
};

struct Supervision {
  const Command& command;
  Clock::time_point begin = Clock::now();
  pid_t pid = 0;
  bool has_ended = false;    // the command itself
  bool has_children = true;  // any descendant at all
  double terminated_at = -1;
  double next_poll_at = kShortestWait_seconds;
  std::size_t folder_at_start = 0;
  MemoryWatch memory = {};
  CpuWatch cpu = {};
  Followed followed = {};
  Report report = {};

  double now() const { return std::chrono::duration<double>(Clock::now() - begin).count(); }
};

void record_exit(Supervision& state, int status) {
  state.has_ended = true;
  state.report.wall_seconds = state.now();
  if (WIFEXITED(status)) state.report.exit_code = WEXITSTATUS(status);
  if (!WIFSIGNALED(status)) return;
  state.report.signal = WTERMSIG(status);
  state.report.core_dumped = WCOREDUMP(status);
}

void reap_children(Supervision& state) {
  int status = 0;
  for (;;) {
    const pid_t pid = ::waitpid(-1, &status, WNOHANG);
    if (pid == state.pid && pid > 0) record_exit(state, status);
    if (pid > 0) continue;
    state.has_children = pid == 0;
    return;
  }
}

void signal_all(int signal) {
  for (const auto& process : descendants_of(::getpid()))
    if (!process.is_zombie) ::kill(process.pid, signal);
}

void terminate(Supervision& state, Cause cause) {
  if (state.terminated_at >= 0 || state.has_ended) return;
  state.report.cause = cause;
  state.terminated_at = state.now();
  signal_all(SIGTERM);
}

bool has_written_more_than(const Supervision& state, std::size_t bytes) {
  return !state.command.folder.empty() && folder_size(state.command.folder) > state.folder_at_start + bytes;
}

void poll_usage(Supervision& state) {
  const double begin = state.now();
  const auto& limits = state.command.limits;
  rusage collected{};
  ::getrusage(RUSAGE_CHILDREN, &collected);
  double cpu_seconds = to_seconds(collected.ru_utime) + to_seconds(collected.ru_stime);
  const auto processes = follow_descendants(state.followed);
  for (const auto& process : processes) cpu_seconds += process.cpu_seconds;
  state.cpu.note(processes);
  cpu_seconds = std::max(cpu_seconds, state.cpu.seconds());
  if (limits.cpu_seconds && cpu_seconds >= *limits.cpu_seconds) terminate(state, Cause::CpuTime);
  if (exceeds_memory(state.memory, processes, limits.memory_bytes)) terminate(state, Cause::Memory);
  if (limits.output_bytes && has_written_more_than(state, *limits.output_bytes))
    terminate(state, Cause::Output);
  const double end = state.now();
  state.next_poll_at =
      end + std::clamp((end - begin) / kPollShare, kShortestWait_seconds, kLongestWait_seconds);
}

void drain_signals(int signals) {
  signalfd_siginfo ignored{};
  while (::read(signals, &ignored, sizeof ignored) > 0) {
  }
}

// Waits until the next deadline or the end of a child; true when the other side wants the command to end.
bool wait_for_event(const Supervision& state, int control, int signals) {
  const auto& limits = state.command.limits;
  double until = std::min(state.next_poll_at, limits.wall_seconds);
  if (state.terminated_at >= 0)
    until = std::min(state.next_poll_at, state.terminated_at + limits.grace_seconds);
  const double wait_ms = std::ceil(1000 * std::max(0.0, until - state.now()));
  std::array<pollfd, 2> files{{{control, POLLIN, 0}, {signals, POLLIN, 0}}};
  // Once termination has begun, the control pipe has nothing more to say.
  if (state.terminated_at >= 0) files[0].fd = -1;
  if (::poll(files.data(), files.size(), static_cast<int>(std::min(wait_ms, 1000.0))) <= 0) return false;
  if (files[0].revents != 0) return true;
  drain_signals(signals);
  return false;
}

int open_signals() {
  // A renderer must not be able to fake an interrupt of the run.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_IGN);
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGCHLD);
  ::sigprocmask(SIG_BLOCK, &signals, nullptr);
  return ::signalfd(-1, &signals, SFD_CLOEXEC | SFD_NONBLOCK);
}

// Sends SIGKILL without SIGTERM. Children of a killed process become ours and are found in the next round.
void kill_survivors(Supervision& state, int signals) {
  const double begin = state.now();
  bool is_first = true;
  while (state.has_children && state.now() < begin + kGiveUp_seconds) {
    const auto left = descendants_of(::getpid());
    for (const auto& process : left) {
      if (process.is_zombie) continue;
      if (is_first && state.has_ended) ++state.report.left_behind;
      ::kill(process.pid, SIGKILL);
    }
    is_first = false;
    reap_children(state);
    constexpr int kPause_ms = 5;
    pollfd child_event{signals, POLLIN, 0};
    if (state.has_children) ::poll(&child_event, 1, kPause_ms);
    drain_signals(signals);
    reap_children(state);
  }
}

// The command may have written a burst between the last poll and its end. The kernel raises SIGXFSZ when a
// file would outgrow the limit, and leaves it at that size; anybody can raise it without having written.
void record_output(Supervision& state) {
  const auto limit = state.command.limits.output_bytes;
  if (state.report.cause != Cause::Nothing || !limit) return;
  const std::size_t cut = state.report.signal == SIGXFSZ && *limit > 0 ? 1 : 0;
  if (has_written_more_than(state, *limit - cut)) state.report.cause = Cause::Output;
}

void record_usage(Supervision& state) {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  state.report.user_seconds = to_seconds(usage.ru_utime);
  state.report.system_seconds = to_seconds(usage.ru_stime);
  const double lost_seconds = state.cpu.seconds() - state.report.user_seconds - state.report.system_seconds;
  state.report.user_seconds += std::max(0.0, lost_seconds);
  state.report.peak_rss_bytes =
      std::max(state.memory.peak_bytes, static_cast<std::size_t>(usage.ru_maxrss) * 1024);
  ::getrusage(RUSAGE_SELF, &usage);
  state.report.supervisor_cpu_seconds = to_seconds(usage.ru_utime) + to_seconds(usage.ru_stime);
}

}  // namespace

Report supervise(const Command& command, int control) {
  Supervision state{command};
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  const int signals = open_signals();
  if (!command.folder.empty()) state.folder_at_start = folder_size(command.folder);
  state.begin = Clock::now();
  const auto started = start(command);
  if (started.error != 0) {
    state.report.start_error = std::strerror(started.error);
    return state.report;
  }
  state.pid = started.pid;
  while (!state.has_ended) {
    if (wait_for_event(state, control, signals)) terminate(state, Cause::Stopped);
    reap_children(state);
    if (state.has_ended) break;
    if (state.now() >= command.limits.wall_seconds) terminate(state, Cause::WallTime);
    if (state.now() >= state.next_poll_at) poll_usage(state);
    if (state.terminated_at >= 0 && state.now() >= state.terminated_at + command.limits.grace_seconds) break;
  }
  kill_survivors(state, signals);
  record_output(state);
  if (!state.has_ended) state.report.wall_seconds = state.now();
  record_usage(state);
  ::close(signals);
  return state.report;
}

}  // namespace orbs::supervisor
