#include "adapters/process.h"

#include "adapters/output_log.h"
#include "adapters/pipe.h"
#include "adapters/supervisor_command.h"
#include "base/error.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <optional>

#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace orbs::adapters {

namespace {

// The strings between us and a supervisor.
struct Strings {
  Pipe control;  // to the supervisor: it ends the command when this closes
  Pipe output;   // of the command
  Pipe report;   // of the supervisor
};

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> out;
  for (auto& text : texts) out.push_back(text.data());
  out.push_back(nullptr);
  return out;
}

// posix_spawn, which reports a failed exec to the caller, and is safe in a program with threads.
int spawn(const ProcessRequest& request, const Strings& strings, pid_t& pid) {
  constexpr int kReport = 3;  // where the supervisor writes
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_adddup2(&actions, strings.control.read_end(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, strings.output.write_end(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, strings.output.write_end(), STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&actions, strings.report.write_end(), kReport);
  posix_spawn_file_actions_addclosefrom_np(&actions, kReport + 1);
  // A session of its own: Ctrl-C in the terminal reaches only us.
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

// Takes what is there; false once nobody holds the other end.
template <typename Take>
bool drain(int file, Take&& take) {
  std::array<char, 65536> buffer{};
  const auto count = ::read(file, buffer.data(), buffer.size());
  if (count > 0) take(std::string_view(buffer.data(), static_cast<std::size_t>(count)));
  return count > 0 || (count < 0 && (errno == EINTR || errno == EAGAIN));
}

// Follows output and report until the supervisor has ended; returns the report's text.
std::string follow(const ProcessRequest& request, Strings& strings, OutputLog& log) {
  constexpr int kLookEvery_ms = 20;  // whether to stop
  std::string report;
  std::exception_ptr failure;
  const auto to_log = [&](std::string_view bytes) {
    try {
      if (!failure) log.append(bytes);
    } catch (const InputError&) {
      failure = std::current_exception();
      strings.control.close_write_end();
    }
  };
  std::array<pollfd, 2> files{
      {{strings.output.read_end(), POLLIN, 0}, {strings.report.read_end(), POLLIN, 0}}};
  for (bool is_there = true; is_there;) {
    if (request.stop != nullptr && request.stop->load()) strings.control.close_write_end();
    if (::poll(files.data(), files.size(), kLookEvery_ms) <= 0) continue;
    if (files[0].revents != 0 && !drain(strings.output.read_end(), to_log)) files[0].fd = -1;
    if (files[1].revents != 0)
      is_there = drain(strings.report.read_end(), [&](std::string_view bytes) { report += bytes; });
  }
  // What the command said before it ended. A process that nothing can kill may hold the pipe for ever.
  while (files[0].fd >= 0 && ::poll(files.data(), 1, 0) > 0 && drain(strings.output.read_end(), to_log)) {
  }
  if (failure) std::rethrow_exception(failure);
  return report;
}

// How the supervisor itself ended: it should have left a report.
std::string reap_supervisor(pid_t pid) {
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? fmt::format("its supervisor was killed by {}", signal_name(WTERMSIG(status)))
                             : fmt::format("its supervisor ended with exit code {}", WEXITSTATUS(status));
}

}  // namespace

ProcessResult run_process(const ProcessRequest& request) {
  ProcessResult result;
  OutputLog log(request.log, request.limits.log_bytes);
  Strings strings;
  pid_t pid = 0;
  const bool has_pipes = strings.control.is_open() && strings.output.is_open() && strings.report.is_open();
  const int error = has_pipes ? spawn(request, strings, pid) : EMFILE;
  if (error != 0) {
    result.start_error = fmt::format("{}: {}", supervisor_command(request).front(), std::strerror(error));
  } else {
    strings.control.close_read_end();
    strings.output.close_write_end();
    strings.report.close_write_end();
    std::string report;
    try {
      report = follow(request, strings, log);
    } catch (const InputError&) {
      reap_supervisor(pid);
      throw;
    }
    const auto how = reap_supervisor(pid);
    if (const auto parsed = supervisor::parse_report(report)) {
      static_cast<supervisor::Report&>(result) = *parsed;
    } else {
      result.lost = how;
    }
  }
  for (const auto& problem : {result.start_error, result.lost})
    if (!problem.empty()) log.append(fmt::format("[orbs: {}: {}]\n", request.argv.at(0), problem));
  result.output = log.finish();
  return result;
}

std::string signal_name(int signal) {
  const char* name = ::sigabbrev_np(signal);
  return name == nullptr ? fmt::format("signal {}", signal) : fmt::format("SIG{}", name);
}

}  // namespace orbs::adapters
