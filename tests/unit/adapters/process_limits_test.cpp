// Renderers that hide from their supervisor or put it out of action.
#include "adapters/process/process.h"
#include "base/files.h"
#include "base/text.h"
#include "structure/source_files.h"
#include "unit/adapters/process_shell.h"

#include <atomic>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

using orbs::adapters::run_process;
using orbs::process_tests::is_running;
using orbs::process_tests::shell;
using orbs::structure::TestFolder;
using orbs::supervisor::Cause;

namespace {

constexpr std::size_t kMega = 1 << 20;

// A name in memory that nobody else has, removed at the end.
struct FilesInMemory {
  std::string name = fmt::format("/dev/shm/orbs-test-{}-", ::getpid());
  FilesInMemory() = default;
  FilesInMemory(const FilesInMemory&) = delete;
  FilesInMemory& operator=(const FilesInMemory&) = delete;
  ~FilesInMemory() {
    std::error_code ignored;
    for (const char* end : {"a", "b"}) std::filesystem::remove(name + end, ignored);
  }
};

bool has_memory_folder() {
  std::error_code failed;
  return std::filesystem::space("/dev/shm", failed).available > 60 * kMega && !failed;
}

// Leaves a process in a session of its own whose parent is gone, says its id, and does the rest then.
std::string with_orphan(const std::string& rest) {
  return "(setsid sh -c 'echo $$ > id; exec sleep 600' &); while [ ! -s id ]; do :; done; cat id; " + rest;
}

// The user interrupts as soon as the log says something.
orbs::adapters::ProcessResult interrupted_at_first_output(orbs::adapters::ProcessRequest request) {
  std::atomic<bool> stop{false};
  request.stop = &stop;
  std::thread user([&] {
    while (!std::filesystem::exists(request.log) || std::filesystem::file_size(request.log) == 0)
      std::this_thread::yield();
    stop = true;
  });
  auto result = run_process(request);
  user.join();
  return result;
}

}  // namespace

// Each of the two is below the limit, and the first is closed when the second is written. It stays open for a
// second because the supervisor learns whose a file is from a process that holds it open while it looks.
TEST(ProcessLimits, FilesInMemoryCountUntilTheyAreRemoved) {
  if (!has_memory_folder()) GTEST_SKIP() << "there is no room in /dev/shm";
  const FilesInMemory files;
  auto request = shell("for f in a b; do exec 3>" + files.name +
                       "$f; head -c 20000000 /dev/zero >&3; sleep 1; exec 3>&-; done; sleep 60");
  request.limits.memory_bytes = 30 * kMega;
  const auto result = run_process(request);
  EXPECT_EQ(result.cause, Cause::Memory);
  EXPECT_GT(result.peak_rss_bytes, 30 * kMega);
}

// The kernel forgets the time of a child whose parent ignores its end.
TEST(ProcessLimits, ProcessorTimeOfChildrenThatNobodyWaitsForCounts) {
  const auto result = run_process(shell(R"(exec python3 -c '
import os, signal, time
signal.signal(signal.SIGCHLD, signal.SIG_IGN)
end, other = os.pipe()
if os.fork() == 0:
    while time.process_time() < 2: pass
    os._exit(0)
os.close(other)
os.read(end, 1)
')"));
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_GT(result.user_seconds + result.system_seconds, 1);
}

// Five shells deep, each waiting for the next.
TEST(ProcessLimits, ProcessorTimeFarBelowTheCommandCounts) {
  const TestFolder scratch("process-deep");
  orbs::write_file(scratch.path() / "deep.sh",
                   "if [ $1 -gt 0 ]; then sh deep.sh $(($1 - 1)); echo; else while :; do :; done; fi");
  auto request = shell("sh deep.sh 4; echo");
  request.folder = scratch.path();
  request.limits.cpu_seconds = 0.2;
  EXPECT_EQ(run_process(request).cause, Cause::CpuTime);
}

TEST(ProcessLimits, ProcessorTimeOfWhatFledToAnotherSessionCounts) {
  auto request = shell("(setsid sh -c 'echo $$; while :; do :; done' &); sleep 60");
  request.limits.cpu_seconds = 0.2;
  const auto result = run_process(request);
  EXPECT_EQ(result.cause, Cause::CpuTime);
  EXPECT_FALSE(is_running(orbs::split(result.output, '\n').at(0))) << result.output;
}

// The kernel lists children by the thread that has started them.
TEST(ProcessLimits, ProcessorTimeOfChildrenOfOtherThreadsCounts) {
  auto request = shell(R"(exec python3 -c '
import os, threading, time
def start():
    if os.fork() == 0:
        while True: pass
    time.sleep(60)
threading.Thread(target=start).start()
')");
  request.limits.cpu_seconds = 1;  // more than python needs to start
  EXPECT_EQ(run_process(request).cause, Cause::CpuTime);
}

// What was there before the job takes no memory of the job.
TEST(ProcessLimits, FilesInMemoryThatAreOnlyReadDoNotCount) {
  if (!has_memory_folder()) GTEST_SKIP() << "there is no room in /dev/shm";
  const FilesInMemory files;
  orbs::write_file(files.name + "a", std::string(40 * kMega, 'x'));
  auto request = shell("exec 3<" + files.name + "a; sleep 1");
  request.limits.memory_bytes = 30 * kMega;
  EXPECT_EQ(run_process(request).cause, Cause::Nothing);
}

TEST(ProcessLimits, ASignalOfTheFileSizeAloneIsNoOutput) {
  const TestFolder scratch("process-signal-xfsz");
  auto request = shell("echo little > file; kill -XFSZ $$");
  request.folder = scratch.path();
  request.limits.output_bytes = 64 * kMega;
  const auto result = run_process(request);
  EXPECT_EQ(result.cause, Cause::Nothing);
  EXPECT_EQ(result.signal, SIGXFSZ);
}

TEST(ProcessLimits, AKilledSupervisorLeavesNothingBehind) {
  const TestFolder scratch("process-killed-supervisor");
  auto request = shell(with_orphan("kill -KILL $PPID; sleep 600"));
  request.folder = scratch.path();
  const auto result = run_process(request);
  EXPECT_EQ(result.orphaned, "its supervisor was killed by SIGKILL");
  EXPECT_FALSE(is_running(orbs::split(result.output, '\n').at(0))) << result.output;
}

TEST(ProcessLimits, AStoppedSupervisorIsGivenUpWithAllThatItRan) {
  const TestFolder scratch("process-stopped-supervisor");
  auto request = shell(with_orphan("echo $PPID; kill -STOP $PPID; sleep 600"));
  request.folder = scratch.path();
  request.limits.wall_seconds = 1;
  request.answer_seconds = 0.2;
  const auto result = run_process(request);
  EXPECT_EQ(result.orphaned, "its supervisor did not answer within 0.3 s after the time limit of 1 s");
  EXPECT_GE(result.wall_seconds, 1.3);
  const auto ids = orbs::split(result.output, '\n');
  ASSERT_GE(ids.size(), 2U) << result.output;
  EXPECT_FALSE(is_running(ids[0]));
  EXPECT_FALSE(is_running(ids[1]));
}

// Its 60 s are far away.
TEST(ProcessLimits, AnInterruptWakesAStoppedSupervisor) {
  const TestFolder scratch("process-interrupt-stopped");
  auto request = shell("kill -STOP $PPID; echo stopped; sleep 600");
  request.log = scratch.path() / "log.txt";
  const auto result = interrupted_at_first_output(std::move(request));
  EXPECT_EQ(result.cause, Cause::Stopped);
  EXPECT_EQ(result.orphaned, "");
  EXPECT_LT(result.wall_seconds, 60);
}

TEST(ProcessLimits, TheEndOfTheHarnessWakesAStoppedSupervisor) {
  const TestFolder scratch("process-killed-harness");
  auto request = shell("kill -STOP $PPID; echo $$ > id; sleep 600");
  request.folder = scratch.path();
  const pid_t harness = ::fork();
  if (harness == 0) {
    run_process(request);
    ::_exit(0);
  }
  const auto id = scratch.path() / "id";
  while (!std::filesystem::exists(id) || std::filesystem::file_size(id) == 0) std::this_thread::yield();
  ::kill(harness, SIGKILL);
  ::waitpid(harness, nullptr, 0);
  EXPECT_FALSE(is_running(orbs::read_file(id)));
}

// It is stopped again and again.
TEST(ProcessLimits, AnInterruptEndsAlsoWhatKeepsItsSupervisorStopped) {
  const TestFolder scratch("process-interrupt-again");
  auto request = shell("trap '' TERM; kill -STOP $PPID; echo stopped; while :; do kill -STOP $PPID; done");
  request.log = scratch.path() / "log.txt";
  request.answer_seconds = 0.2;
  const auto result = interrupted_at_first_output(std::move(request));
  EXPECT_EQ(result.cause, Cause::Stopped);
  EXPECT_LT(result.wall_seconds, 60);
}
