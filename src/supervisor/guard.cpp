#include "supervisor/guard.h"

#include "supervisor/descendants.h"
#include "supervisor/folder_size.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

namespace orbs::supervisor {

namespace {

using Clock = std::chrono::steady_clock;

// Looking through /proc must not disturb what is measured: 0.5 % of one core at most, and at least two looks
// a second, since what a look misses is not limited.
constexpr double kLookShare = 0.005;
constexpr double kShortestWait_seconds = 0.01;
constexpr double kLongestWait_seconds = 0.5;

// For a process that even KILL does not end: it hangs in the kernel, on a lost network disk for example.
constexpr double kGiveUp_seconds = 10;

double to_seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

struct Watch {
  const Order& order;
  Clock::time_point begin = Clock::now();
  pid_t command = 0;
  bool has_ended = false;    // the command itself
  bool has_children = true;  // anything at all below us
  double terminated_at = -1;
  double look_at = kShortestWait_seconds;
  std::size_t folder_at_start = 0;
  Report report = {};

  double now() const { return std::chrono::duration<double>(Clock::now() - begin).count(); }
};

void note_end(Watch& watch, int status) {
  watch.has_ended = true;
  watch.report.wall_seconds = watch.now();
  if (WIFEXITED(status)) watch.report.exit_code = WEXITSTATUS(status);
  if (!WIFSIGNALED(status)) return;
  watch.report.signal = WTERMSIG(status);
  watch.report.core_dumped = WCOREDUMP(status);
  if (watch.report.signal == SIGXFSZ) watch.report.cause = Cause::Output;
}

void collect_children(Watch& watch) {
  int status = 0;
  for (;;) {
    const pid_t pid = ::waitpid(-1, &status, WNOHANG);
    if (pid == watch.command && pid > 0) note_end(watch, status);
    if (pid > 0) continue;
    watch.has_children = pid == 0;
    return;
  }
}

void signal_all(int signal) {
  for (const auto& process : descendants_of(::getpid()))
    if (!process.is_zombie) ::kill(process.pid, signal);
}

void terminate(Watch& watch, Cause cause) {
  if (watch.terminated_at >= 0 || watch.has_ended) return;
  watch.report.cause = cause;
  watch.terminated_at = watch.now();
  signal_all(SIGTERM);
}

void look(Watch& watch) {
  const double begin = watch.now();
  const auto& limits = watch.order.limits;
  rusage collected{};
  ::getrusage(RUSAGE_CHILDREN, &collected);
  double cpu_seconds = to_seconds(collected.ru_utime) + to_seconds(collected.ru_stime);
  Memory memory;
  for (const auto& process : descendants_of(::getpid())) {
    cpu_seconds += process.cpu_seconds;
    const auto of_this = memory_of(process.pid);
    memory.resident_bytes += of_this.resident_bytes;
    memory.unbacked_bytes += of_this.unbacked_bytes;
  }
  watch.report.peak_rss_bytes = std::max(watch.report.peak_rss_bytes, memory.resident_bytes);
  if (limits.cpu_seconds && cpu_seconds >= *limits.cpu_seconds) terminate(watch, Cause::CpuTime);
  if (limits.memory_bytes && memory.unbacked_bytes > *limits.memory_bytes) terminate(watch, Cause::Memory);
  if (limits.output_bytes && !watch.order.folder.empty() &&
      folder_size(watch.order.folder) > watch.folder_at_start + *limits.output_bytes)
    terminate(watch, Cause::Output);
  const double end = watch.now();
  watch.look_at = end + std::clamp((end - begin) / kLookShare, kShortestWait_seconds, kLongestWait_seconds);
}

void forget_signals(int signals) {
  signalfd_siginfo ignored{};
  while (::read(signals, &ignored, sizeof ignored) > 0) {
  }
}

// Waits for the next thing to do or a child to end; true when the other side wants the command to end.
bool wait_for_news(const Watch& watch, int control, int signals) {
  const auto& limits = watch.order.limits;
  double until = std::min(watch.look_at, limits.wall_seconds);
  if (watch.terminated_at >= 0) until = std::min(watch.look_at, watch.terminated_at + limits.grace_seconds);
  const double wait_ms = std::ceil(1000 * std::max(0.0, until - watch.now()));
  std::array<pollfd, 2> files{{{control, POLLIN, 0}, {signals, POLLIN, 0}}};
  // Once asked to stop there is nothing more to hear from the other side.
  if (watch.terminated_at >= 0) files[0].fd = -1;
  if (::poll(files.data(), files.size(), static_cast<int>(std::min(wait_ms, 1000.0))) <= 0) return false;
  if (files[0].revents != 0) return true;
  forget_signals(signals);
  return false;
}

int open_signals() {
  // A renderer must not be able to pretend that somebody had interrupted the run.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_IGN);
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGCHLD);
  ::sigprocmask(SIG_BLOCK, &signals, nullptr);
  return ::signalfd(-1, &signals, SFD_CLOEXEC | SFD_NONBLOCK);
}

// Nobody is asked any more; children of what is killed become ours and come up in the next round.
void sweep(Watch& watch, int signals) {
  const double begin = watch.now();
  bool is_first = true;
  while (watch.has_children && watch.now() < begin + kGiveUp_seconds) {
    const auto left = descendants_of(::getpid());
    for (const auto& process : left) {
      if (process.is_zombie) continue;
      if (is_first && watch.has_ended) ++watch.report.left_behind;
      ::kill(process.pid, SIGKILL);
    }
    is_first = false;
    collect_children(watch);
    constexpr int kPause_ms = 5;
    pollfd news{signals, POLLIN, 0};
    if (watch.has_children) ::poll(&news, 1, kPause_ms);
    forget_signals(signals);
    collect_children(watch);
  }
}

void note_costs(Watch& watch) {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  watch.report.user_seconds = to_seconds(usage.ru_utime);
  watch.report.system_seconds = to_seconds(usage.ru_stime);
  watch.report.peak_rss_bytes =
      std::max(watch.report.peak_rss_bytes, static_cast<std::size_t>(usage.ru_maxrss) * 1024);
  ::getrusage(RUSAGE_SELF, &usage);
  watch.report.supervisor_cpu_seconds = to_seconds(usage.ru_utime) + to_seconds(usage.ru_stime);
}

}  // namespace

Report guard(const Order& order, int control) {
  Watch watch{order};
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  const int signals = open_signals();
  if (!order.folder.empty()) watch.folder_at_start = folder_size(order.folder);
  watch.begin = Clock::now();
  const auto started = start(order);
  if (started.error != 0) {
    watch.report.start_error = std::strerror(started.error);
    return watch.report;
  }
  watch.command = started.pid;
  while (!watch.has_ended) {
    if (wait_for_news(watch, control, signals)) terminate(watch, Cause::Stopped);
    collect_children(watch);
    if (watch.has_ended) break;
    if (watch.now() >= order.limits.wall_seconds) terminate(watch, Cause::WallTime);
    if (watch.now() >= watch.look_at) look(watch);
    if (watch.terminated_at >= 0 && watch.now() >= watch.terminated_at + order.limits.grace_seconds) break;
  }
  sweep(watch, signals);
  // A burst between the last look and the end.
  if (watch.report.cause == Cause::Nothing && order.limits.output_bytes && !order.folder.empty() &&
      folder_size(order.folder) > watch.folder_at_start + *order.limits.output_bytes)
    watch.report.cause = Cause::Output;
  if (!watch.has_ended) watch.report.wall_seconds = watch.now();
  note_costs(watch);
  ::close(signals);
  return watch.report;
}

}  // namespace orbs::supervisor
