#include "adapters/process/process.h"

#include "adapters/process/output_log.h"
#include "adapters/process/supervised_child.h"
#include "base/error.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <optional>

#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace orbs::adapters {

namespace {

// Reads the bytes that are there; false once nobody holds the other end.
template <typename Consume>
bool drain(int file, Consume&& consume) {
  std::array<char, 65536> buffer{};
  const auto count = ::read(file, buffer.data(), buffer.size());
  if (count > 0) consume(std::string_view(buffer.data(), static_cast<std::size_t>(count)));
  return count > 0 || (count < 0 && (errno == EINTR || errno == EAGAIN));
}

// Follows output and report until the supervisor has ended; returns the report's text.
std::string follow(const ProcessRequest& request, Pipes& pipes, OutputLog& log) {
  constexpr int kPollPeriod_ms = 20;  // of the flag `stop`
  std::string report;
  std::exception_ptr failure;
  const auto to_log = [&](std::string_view bytes) {
    try {
      if (!failure) log.append(bytes);
    } catch (const InputError&) {
      failure = std::current_exception();
      pipes.control.close_write_end();
    }
  };
  std::array<pollfd, 2> files{{{pipes.output.read_end(), POLLIN, 0}, {pipes.report.read_end(), POLLIN, 0}}};
  for (bool is_there = true; is_there;) {
    if (request.stop != nullptr && request.stop->load()) pipes.control.close_write_end();
    if (::poll(files.data(), files.size(), kPollPeriod_ms) <= 0) continue;
    if (files[0].revents != 0 && !drain(pipes.output.read_end(), to_log)) files[0].fd = -1;
    if (files[1].revents != 0)
      is_there = drain(pipes.report.read_end(), [&](std::string_view bytes) { report += bytes; });
  }
  // Output that the command wrote before it ended. A process that cannot be killed may hold the pipe for
  // ever.
  while (files[0].fd >= 0 && ::poll(files.data(), 1, 0) > 0 && drain(pipes.output.read_end(), to_log)) {
  }
  if (failure) std::rethrow_exception(failure);
  return report;
}

// How a supervisor ended that left no report.
std::string end_of_supervisor(int status) {
  return WIFSIGNALED(status) ? fmt::format("its supervisor was killed by {}", signal_name(WTERMSIG(status)))
                             : fmt::format("its supervisor ended with exit code {}", WEXITSTATUS(status));
}

}  // namespace

ProcessResult run_process(const ProcessRequest& request) {
  ProcessResult result;
  OutputLog log(request.log, request.limits.log_bytes);
  Pipes pipes;
  pid_t pid = 0;
  if (const int error = start_supervisor(request, pipes, pid); error != 0) {
    result.start_error = fmt::format("{}: {}", supervisor_command(request).front(), std::strerror(error));
  } else {
    std::string report;
    try {
      report = follow(request, pipes, log);
    } catch (const InputError&) {
      reap_supervisor(pid);
      throw;
    }
    const int status = reap_supervisor(pid);
    if (const auto parsed = supervisor::parse_report(report)) {
      static_cast<supervisor::Report&>(result) = *parsed;
    } else {
      result.orphaned = end_of_supervisor(status);
    }
  }
  for (const auto& problem : {result.start_error, result.orphaned})
    if (!problem.empty()) log.append(fmt::format("[orbs: {}: {}]\n", request.argv.at(0), problem));
  result.output = log.finish();
  return result;
}

std::string signal_name(int signal) {
  const char* name = ::sigabbrev_np(signal);
  return name == nullptr ? fmt::format("signal {}", signal) : fmt::format("SIG{}", name);
}

}  // namespace orbs::adapters
