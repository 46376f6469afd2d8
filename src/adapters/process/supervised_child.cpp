#include "adapters/process/supervised_child.h"

#include "base/files.h"
#include "supervisor/descendants.h"
#include "supervisor/supervise.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <mutex>
#include <set>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace orbs::adapters {

Pipe::Pipe() {
  if (::pipe2(ends_.data(), O_CLOEXEC) != 0) return;
  constexpr int kLowest = 4;
  for (auto& end : ends_) {
    if (end >= kLowest) continue;
    const int low = std::exchange(end, ::fcntl(end, F_DUPFD_CLOEXEC, kLowest));
    ::close(low);
  }
}

Pipe::~Pipe() {
  close_read_end();
  close_write_end();
}

void Pipe::close_read_end() {
  if (ends_[0] >= 0) ::close(std::exchange(ends_[0], -1));
}

void Pipe::close_write_end() {
  if (ends_[1] >= 0) ::close(std::exchange(ends_[1], -1));
}

namespace {

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> out;
  for (auto& text : texts) out.push_back(text.data());
  out.push_back(nullptr);
  return out;
}

// The supervisors that we started and have not reaped. Whoever tells our other children from them holds the
// mutex, as does whoever starts one.
struct Supervisors {
  std::mutex mutex;
  std::set<pid_t> ids;
};

Supervisors& our_supervisors() {
  static Supervisors supervisors;
  return supervisors;
}

// posix_spawn reports a failed exec to the caller and is safe in a program with threads.
int spawn(const ProcessRequest& request, const Pipes& pipes, pid_t& pid) {
  constexpr int kReport = 3;  // where the supervisor writes
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_adddup2(&actions, pipes.control.read_end(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, pipes.output.write_end(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, pipes.output.write_end(), STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&actions, pipes.report.write_end(), kReport);
  posix_spawn_file_actions_addclosefrom_np(&actions, kReport + 1);
  // A new session: Ctrl-C in the terminal reaches only us.
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  sigset_t signals;
  sigfillset(&signals);
  posix_spawnattr_setsigdefault(&attributes, &signals);
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&attributes, &signals);
  auto argv = supervisor_command(request);
  auto environment = request.environment;
  const int error = posix_spawn(&pid, argv.front().c_str(), &actions, &attributes, pointers(argv).data(),
                                pointers(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

}  // namespace

std::vector<std::string> supervisor_command(const ProcessRequest& request) {
  static const auto supervisor = beside_program("orbs-supervisor");
  const auto& limits = request.limits;
  std::vector<std::string> words{supervisor.string()};
  const auto add = [&](const char* option, const std::string& value) {
    words.insert(words.end(), {option, value});
  };
  if (!request.folder.empty()) add("--folder", request.folder.string());
  add("--wall-seconds", fmt::format("{}", limits.wall_seconds));
  if (limits.cpu_seconds) add("--cpu-seconds", fmt::format("{}", *limits.cpu_seconds));
  if (limits.memory_bytes) add("--memory-bytes", fmt::format("{}", *limits.memory_bytes));
  if (limits.output_bytes) add("--output-bytes", fmt::format("{}", *limits.output_bytes));
  if (request.has_own_keyring) add("--own-keyring", "1");
  add("--grace-seconds", fmt::format("{}", limits.grace_seconds));
  words.emplace_back("--");
  words.insert(words.end(), request.argv.begin(), request.argv.end());
  return words;
}

int start_supervisor(const ProcessRequest& request, Pipes& pipes, pid_t& pid) {
  const bool has_pipes = pipes.control.is_open() && pipes.output.is_open() && pipes.report.is_open();
  int error = EMFILE;
  if (has_pipes) {
    auto& supervisors = our_supervisors();
    const std::lock_guard lock(supervisors.mutex);
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    error = spawn(request, pipes, pid);
    if (error == 0) supervisors.ids.insert(pid);
  }
  pipes.control.close_read_end();
  pipes.output.close_write_end();
  pipes.report.close_write_end();
  return error;
}

int reap_supervisor(pid_t pid) {
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  auto& supervisors = our_supervisors();
  const std::lock_guard lock(supervisors.mutex);
  supervisors.ids.erase(pid);
  return status;
}

namespace {

void kill_with_descendants(pid_t pid) {
  for (const auto& process : supervisor::descendants_of(pid)) ::kill(process.pid, SIGKILL);
  ::kill(pid, SIGKILL);
}

// Asks again and again, and gives up on what hangs in the kernel.
bool wait_until(const std::function<bool()>& is_done) {
  using Clock = std::chrono::steady_clock;
  constexpr int kPause_ms = 5;
  const auto end = Clock::now() + std::chrono::duration<double>(supervisor::kGiveUp_seconds);
  while (!is_done()) {
    if (Clock::now() >= end) return false;
    ::poll(nullptr, 0, kPause_ms);
  }
  return true;
}

}  // namespace

void kill_supervisor(pid_t pid) {
  kill_with_descendants(pid);
  const auto has_ended = [&] { return ::waitpid(pid, nullptr, WNOHANG) != 0; };
  if (!wait_until(has_ended)) return;
  auto& supervisors = our_supervisors();
  const std::lock_guard lock(supervisors.mutex);
  supervisors.ids.erase(pid);
}

void kill_orphans() {
  auto& supervisors = our_supervisors();
  const std::lock_guard lock(supervisors.mutex);
  wait_until([&] {
    bool found_none = true;
    for (const auto& process : supervisor::descendants_of(::getpid())) {
      if (process.parent != ::getpid() || supervisors.ids.contains(process.pid)) continue;
      if (::getsid(process.pid) == ::getsid(0)) continue;  // the browser, for example
      kill_with_descendants(process.pid);
      ::waitpid(process.pid, nullptr, WNOHANG);
      found_none = false;  // what was below it may have become our child meanwhile
    }
    return found_none;
  });
}

}  // namespace orbs::adapters
