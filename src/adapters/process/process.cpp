#include "adapters/process/process.h"

#include "adapters/process/supervised_child.h"
#include "base/error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace orbs::adapters {

namespace {

// Output of a program, bounded: the first half of the allowance is written as it arrives, so that the file
// can be followed while the program runs; of all later output the last half is kept.
class OutputLog {
 public:
  /// `file` may be empty: memory only. An existing file is continued, for the seeds of a job share their log.
  /// WriteError, here and below, when the disk refuses.
  OutputLog(const std::filesystem::path& file, std::size_t most_bytes);
  void append(std::string_view bytes);
  /// Writes the part that is still held back and returns all that was kept.
  std::string finish();

 private:
  std::filesystem::path path_;
  std::ofstream file_;
  std::size_t half_;
  std::string head_;
  std::string tail_;
  std::size_t left_out_ = 0;
};

OutputLog::OutputLog(const std::filesystem::path& file, std::size_t most_bytes)
    : path_(file), half_(most_bytes / 2) {
  if (path_.empty()) return;
  file_.open(path_, std::ios::binary | std::ios::app);
  if (!file_)
    throw WriteError(fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
}

void OutputLog::append(std::string_view bytes) {
  const auto to_head = std::min(bytes.size(), half_ - head_.size());
  head_ += bytes.substr(0, to_head);
  if (!path_.empty() && !(file_ << bytes.substr(0, to_head) << std::flush))
    throw WriteError(fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
  tail_ += bytes.substr(to_head);
  // Cut at twice the allowance only, so that each byte is moved once on average.
  if (tail_.size() <= 2 * half_) return;
  left_out_ += tail_.size() - half_;
  tail_.erase(0, tail_.size() - half_);
}

std::string OutputLog::finish() {
  if (tail_.size() > half_) {
    left_out_ += tail_.size() - half_;
    tail_.erase(0, tail_.size() - half_);
  }
  const auto rest = left_out_ == 0 ? tail_ : fmt::format("\n[orbs: {} bytes left out]\n{}", left_out_, tail_);
  if (!path_.empty()) {
    file_ << rest << std::flush;
    if (!file_)
      throw WriteError(fmt::format("{}: cannot be written: {}", path_.string(), std::strerror(errno)));
  }
  return head_ + rest;
}

using Clock = std::chrono::steady_clock;

// Reads the bytes that are there; false once nobody holds the other end.
template <typename Consume>
bool drain(int file, Consume&& consume) {
  std::array<char, 65536> buffer{};
  const auto count = ::read(file, buffer.data(), buffer.size());
  if (count > 0) consume(std::string_view(buffer.data(), static_cast<std::size_t>(count)));
  return count > 0 || (count < 0 && (errno == EINTR || errno == EAGAIN));
}

// The first failure is kept until the supervisor has ended; what comes after it is not written.
void append(std::string_view bytes, OutputLog& log, std::exception_ptr& failure) {
  try {
    if (!failure) log.append(bytes);
  } catch (const InputError&) {
    failure = std::current_exception();
  }
}

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Until when we wait for the report: the supervisor may be stopped, or hang on a disk that is gone.
struct Deadline {
  double at_seconds = 0;  // after the start
  std::string reason;     // what is said when it passes
};

Deadline deadline_after(double end_seconds, const std::string& end, const ProcessRequest& request) {
  const double wait_seconds = request.limits.grace_seconds + request.answer_seconds;
  return {end_seconds + wait_seconds,
          fmt::format("its supervisor did not answer within {:.6g} s after {}", wait_seconds, end)};
}

// What came from a supervisor until it ended or had to be given up.
struct Followed {
  std::string report;
  std::string unanswered;  // why it was given up; "" when it ended
  bool is_interrupted = false;
  std::exception_ptr failure;  // of the log
};

// Tells the supervisor to end the command, also one that somebody has stopped.
void ask_to_end(pid_t supervisor, Pipes& pipes) {
  pipes.control.close_write_end();
  ::kill(supervisor, SIGCONT);
}

// Follows output and report until the supervisor has ended or its time to answer is over. The report comes
// first: we may have been stopped ourselves.
Followed follow(const ProcessRequest& request, pid_t supervisor, Pipes& pipes, OutputLog& log) {
  constexpr int kPollPeriod_ms = 20;  // of the flag `stop`
  const auto begin = Clock::now();
  Followed followed;
  auto deadline =
      deadline_after(request.limits.wall_seconds,
                     fmt::format("the time limit of {:.6g} s", request.limits.wall_seconds), request);
  const auto to_log = [&](std::string_view bytes) { append(bytes, log, followed.failure); };
  std::array<pollfd, 2> files{{{pipes.output.read_end(), POLLIN, 0}, {pipes.report.read_end(), POLLIN, 0}}};
  for (bool is_there = true; is_there && followed.unanswered.empty();) {
    followed.is_interrupted = request.stop != nullptr && request.stop->load();
    if ((followed.is_interrupted || followed.failure) && pipes.control.write_end() >= 0) {
      ask_to_end(supervisor, pipes);
      auto sooner = deadline_after(seconds_since(begin), "the interrupt of the run", request);
      if (sooner.at_seconds < deadline.at_seconds) deadline = std::move(sooner);
    }
    const bool is_late = seconds_since(begin) >= deadline.at_seconds;
    const bool has_event = ::poll(files.data(), files.size(), kPollPeriod_ms) > 0;
    if (has_event && files[0].revents != 0 && !drain(pipes.output.read_end(), to_log)) files[0].fd = -1;
    if (has_event && files[1].revents != 0)
      is_there = drain(pipes.report.read_end(), [&](std::string_view bytes) { followed.report += bytes; });
    else if (is_late)
      followed.unanswered = deadline.reason;
  }
  return followed;
}

// Output that the command wrote before it ended. A process that cannot be killed may hold the pipe for ever.
void drain_rest(const Pipes& pipes, OutputLog& log, std::exception_ptr& failure) {
  pollfd output{pipes.output.read_end(), POLLIN, 0};
  const auto to_log = [&](std::string_view bytes) { append(bytes, log, failure); };
  while (::poll(&output, 1, 0) > 0 && drain(output.fd, to_log)) {
  }
}

// How a supervisor ended that left no report.
std::string end_of_supervisor(int status) {
  return WIFSIGNALED(status) ? fmt::format("its supervisor was killed by {}", signal_name(WTERMSIG(status)))
                             : fmt::format("its supervisor ended with exit code {}", WEXITSTATUS(status));
}

// A terminal or a batch system signals all processes of a job, in any order: a command that such a signal has
// ended, a shell that says so of its command included, was interrupted with us if we get it as well. Half a
// second is long for a signal to arrive, and a crash of this kind is rare enough to wait for it.
bool is_interrupted_with_us(const ProcessRequest& request, const supervisor::Report& report) {
  constexpr int kShell = 128;  // a shell's exit code is this and the signal of its command
  constexpr auto kLongest = std::chrono::milliseconds(500);
  constexpr auto kPeriod = std::chrono::milliseconds(5);
  const std::array signals{SIGTERM, SIGINT, SIGHUP};
  const bool is_signalled = std::any_of(signals.begin(), signals.end(), [&](int signal) {
    return report.signal == signal || report.exit_code == kShell + signal;
  });
  if (request.stop == nullptr || report.cause != supervisor::Cause::Nothing || !is_signalled) return false;
  for (const auto end = Clock::now() + kLongest; !request.stop->load() && Clock::now() < end;)
    std::this_thread::sleep_for(kPeriod);
  return request.stop->load();
}

// Follows a supervisor that was started to its end, or makes an end of it and of all that it ran.
ProcessResult finish(const ProcessRequest& request, pid_t supervisor, Pipes& pipes, OutputLog& log) {
  ProcessResult result;
  const auto begin = Clock::now();
  auto followed = follow(request, supervisor, pipes, log);
  const auto report = supervisor::parse_report(followed.report);
  if (!followed.unanswered.empty()) {
    kill_supervisor(supervisor);
    result.orphaned = followed.unanswered;
  } else if (const int status = reap_supervisor(supervisor); !report) {
    result.orphaned = end_of_supervisor(status);
  }
  if (!result.orphaned.empty()) kill_orphans();
  drain_rest(pipes, log, followed.failure);
  if (followed.failure) std::rethrow_exception(followed.failure);
  if (report) {
    static_cast<supervisor::Report&>(result) = *report;
    result.orphaned.clear();
    if (is_interrupted_with_us(request, *report)) result.cause = supervisor::Cause::Stopped;
    return result;
  }
  result.wall_seconds = seconds_since(begin);
  if (followed.is_interrupted) result.cause = supervisor::Cause::Stopped;
  return result;
}

}  // namespace

ProcessResult run_process(const ProcessRequest& request) {
  ProcessResult result;
  OutputLog log(request.log, request.limits.log_bytes);
  Pipes pipes;
  pid_t pid = 0;
  if (const int error = start_supervisor(request, pipes, pid); error != 0)
    result.start_error = fmt::format("{}: {}", supervisor_command(request).front(), std::strerror(error));
  else
    result = finish(request, pid, pipes, log);
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
