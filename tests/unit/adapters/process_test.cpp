#include "adapters/process/process.h"

#include "adapters/process/programs.h"
#include "base/files.h"
#include "base/text.h"
#include "structure/source_files.h"
#include "unit/adapters/process_shell.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

using orbs::adapters::ProcessRequest;
using orbs::adapters::run_process;
using orbs::process_tests::is_running;
using orbs::process_tests::shell;
using orbs::structure::TestFolder;
using orbs::supervisor::Cause;

TEST(Process, OutputAndErrorsGoToTheLogInTheirOrder) {
  const TestFolder scratch("process-log");
  auto request = shell("echo one; echo two >&2; echo three");
  request.log = scratch.path() / "log.txt";
  const auto result = run_process(request);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output, "one\ntwo\nthree\n");
  EXPECT_EQ(orbs::read_file(request.log), result.output);
}

TEST(Process, OutputBeyondTheAllowanceIsLeftOutOfTheMiddle) {
  auto request = shell("printf '%0100d' 0 | tr 0 a; printf '%01000d' 0 | tr 0 b; printf '%0100d' 0 | tr 0 c");
  request.limits.log_bytes = 200;
  EXPECT_EQ(run_process(request).output,
            fmt::format("{:a>100}\n[orbs: 1000 bytes left out]\n{:c>100}", "", ""));
}

TEST(Process, AnExitCodeIsKept) { EXPECT_EQ(run_process(shell("exit 7")).exit_code, 7); }

// What a signal killed has no exit code above 0, and must not pass for that.
TEST(Process, ASignalIsNoExitCode) {
  const auto result = run_process(shell("kill -SEGV $$"));
  EXPECT_EQ(result.signal, SIGSEGV);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(orbs::adapters::signal_name(result.signal), "SIGSEGV");
}

TEST(Process, WhatCannotStartSaysWhy) {
  ProcessRequest request;
  request.argv = {"/nowhere/at/all"};
  EXPECT_EQ(run_process(request).start_error, "No such file or directory");
}

TEST(Process, WhatIsNoProgramSaysWhy) {
  const TestFolder scratch("process-no-program");
  scratch.write("text", "no program");
  ::chmod((scratch.path() / "text").c_str(), 0755);
  ProcessRequest request;
  request.argv = {(scratch.path() / "text").string()};
  EXPECT_EQ(run_process(request).start_error, "Exec format error");
}

TEST(Process, HasNoInput) { EXPECT_EQ(run_process(shell("cat; echo end")).output, "end\n"); }

TEST(Process, StartsInItsFolder) {
  const TestFolder scratch("process-folder");
  auto request = shell("pwd -P");
  request.folder = scratch.path();
  EXPECT_EQ(run_process(request).output, std::filesystem::canonical(scratch.path()).string() + "\n");
}

TEST(Process, SeesOnlyTheEnvironmentThatIsGiven) {
  ::setenv("ORBS_TEST_SECRET", "1", 1);
  auto request = shell("echo ${ORBS_TEST_SECRET-unset} $ORBS_TEST_GIVEN");
  request.environment.emplace_back("ORBS_TEST_GIVEN=2");
  EXPECT_EQ(run_process(request).output, "unset 2\n");
}

TEST(Process, InheritsNoOpenFile) {
  const TestFolder scratch("process-files");
  scratch.write("open.txt", "");
  std::FILE* open = std::fopen((scratch.path() / "open.txt").c_str(), "r");
  const auto result = run_process(shell("ls -l /proc/self/fd"));
  std::fclose(open);
  EXPECT_EQ(result.output.find("open.txt"), std::string::npos) << result.output;
}

// Both ignore TERM; the child would go on for ten minutes.
TEST(Process, AtItsTimeLimitItEndsWithAllThatItStarted) {
  auto request =
      shell("trap '' TERM; sh -c 'trap \"\" TERM; echo $$; while :; do sleep 600; done' & wait; wait");
  request.limits.wall_seconds = 0.4;
  const auto result = run_process(request);
  EXPECT_EQ(result.cause, Cause::WallTime);
  EXPECT_EQ(result.signal, SIGKILL);
  EXPECT_GE(result.wall_seconds, 0.4);
  EXPECT_FALSE(is_running(result.output));
}

// As by a batch system that signals the processes of a job one by one: the command first, and us after it.
TEST(Process, AnInterruptThatReachesTheCommandFirstIsNoCrash) {
  const TestFolder scratch("process-interrupt");
  const auto ready = scratch.path() / "ready";
  for (const char* end : {"kill -TERM $$", "exit 143"}) {
    std::filesystem::remove(ready);
    std::atomic<bool> stop{false};
    auto request = shell(fmt::format("touch {}; {}", ready.string(), end));
    request.stop = &stop;
    std::thread interrupt([&] {
      while (!std::filesystem::exists(ready)) std::this_thread::yield();
      stop = true;
    });
    EXPECT_EQ(run_process(request).cause, Cause::Stopped) << end;
    interrupt.join();
  }
  const std::atomic<bool> never{false};
  auto request = shell("kill -TERM $$");
  request.stop = &never;
  const auto crashed = run_process(request);
  EXPECT_EQ(crashed.cause, Cause::Nothing);
  EXPECT_EQ(crashed.signal, SIGTERM);
}

TEST(Process, WhatItLeavesBehindIsEndedWithIt) {
  const auto result = run_process(shell("sleep 600 & echo $!"));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_LT(result.wall_seconds, 60);
  EXPECT_FALSE(is_running(result.output));
}

// The first has a session of its own, the second is a grandchild whose parent is gone.
TEST(Process, WhatFledToAnotherSessionIsEndedWithIt) {
  const TestFolder scratch("process-session");
  // The shell ends when both are there.
  const auto result = run_process(shell(fmt::format(
      "(setsid sh -c 'echo $$ >> {0}; sh -c \"echo \\$\\$ >> {0}; exec sleep 600\" & exec sleep 600' &); "
      "until test \"$(wc -l < {0} || echo 0)\" -ge 2; do sleep 0.01; done 2> /dev/null; cat {0}",
      (scratch.path() / "ids").string())));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_GE(result.left_behind, 2);
  const auto ids = orbs::split(result.output, '\n');
  ASSERT_EQ(ids.size(), 3U) << result.output;
  EXPECT_FALSE(is_running(ids[0]));
  EXPECT_FALSE(is_running(ids[1]));
}

// Bounded at 60 s of its own, should nobody stop it.
TEST(Process, IsEndedAtItsLimitOfProcessorTimeOfAllItsChildren) {
  auto request = shell("for i in 1 2 3; do timeout 60 sh -c 'while :; do :; done' & done; wait");
  request.limits.cpu_seconds = 0.2;
  const auto result = run_process(request);
  EXPECT_EQ(result.cause, Cause::CpuTime);
  EXPECT_GE(result.user_seconds + result.system_seconds, 0.2);
  EXPECT_LT(result.wall_seconds, 30);
}

TEST(Process, IsEndedAtItsMemoryLimitOfAllItsChildren) {
  // Each of the two stays below it.
  auto request =
      shell("for i in 1 2; do head -c 60000000 /dev/zero | tail -c 60000000 | sleep 60 & done; wait");
  request.limits.memory_bytes = 90 << 20;
  const auto result = run_process(request);
  EXPECT_EQ(result.cause, Cause::Memory);
  EXPECT_GT(result.peak_rss_bytes, 90U << 20);
}

TEST(Process, AFileBeyondTheAllowanceIsCutShort) {
  const TestFolder scratch("process-file");
  scratch.write("ours.txt", std::string(100000, 'x'));  // does not count
  auto request = shell("exec head -c 3000000 /dev/zero > large");
  request.folder = scratch.path();
  request.limits.output_bytes = 1 << 20;
  const auto result = run_process(request);
  EXPECT_EQ(result.cause, Cause::Output);
  EXPECT_EQ(result.signal, SIGXFSZ);
  EXPECT_EQ(std::filesystem::file_size(scratch.path() / "large"), 1U << 20);
}

TEST(Process, ManyFilesBeyondTheAllowanceAreFound) {
  const TestFolder scratch("process-many-files");
  scratch.write("ours.txt", "");
  auto request = shell("mkdir in; for i in 1 2 3; do head -c 500000 /dev/zero > in/$i; done");
  request.folder = scratch.path();
  request.limits.output_bytes = 1 << 20;
  EXPECT_EQ(run_process(request).cause, Cause::Output);
}

// Whoever starts it holds one end of its string: when the harness is killed, nothing goes on without it.
TEST(Process, CannotPretendAnInterruptToItsSupervisor) {
  const auto result = run_process(shell("kill -INT $PPID; kill -TERM $PPID; kill -HUP $PPID; exit 5"));
  EXPECT_EQ(result.cause, Cause::Nothing);
  EXPECT_EQ(result.exit_code, 5);
}

TEST(Process, ThatKillsItsSupervisorIsKilledAndReported) {
  const auto result = run_process(shell("kill -KILL $PPID; sleep 600"));
  EXPECT_EQ(result.orphaned, "its supervisor was killed by SIGKILL");
  EXPECT_EQ(result.start_error, "");
}

TEST(Process, IsEndedWhenTheRunIsInterrupted) {
  const std::atomic<bool> stop{true};
  auto request = shell("sleep 600");
  request.stop = &stop;
  const auto result = run_process(request);
  EXPECT_EQ(result.cause, Cause::Stopped);
}

// A loop of 300 000 additions takes far more than a millisecond on any machine; the bound above is the wall
// time.
TEST(Process, MeasuresProcessorTime) {
  const auto result = run_process(shell("i=0; while [ $i -lt 300000 ]; do i=$((i+1)); done"));
  EXPECT_GT(result.user_seconds, 0.001);
  EXPECT_LE(result.user_seconds + result.system_seconds, result.wall_seconds + 0.1);
}

// The shell needs a few megabytes; ours must not be counted as its own.
TEST(Process, MeasuresItsOwnMemoryAndNotOurs) {
  constexpr std::size_t kOurs = 200 << 20;
  const std::string ours(kOurs, 'x');
  ASSERT_EQ(ours.back(), 'x');
  const auto result = run_process(shell("i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done"));
  EXPECT_GT(result.peak_rss_bytes, 100U << 10);
  EXPECT_LT(result.peak_rss_bytes, kOurs / 4);
}

TEST(Programs, AreFoundOnThePathAndMustBeExecutable) {
  const TestFolder scratch("programs");
  scratch.write("plain.txt", "");
  EXPECT_TRUE(orbs::adapters::find_program("sh").has_value());
  EXPECT_FALSE(orbs::adapters::find_program("no-such-program-at-all").has_value());
  EXPECT_FALSE(orbs::adapters::find_program((scratch.path() / "plain.txt").string()).has_value());
  EXPECT_FALSE(orbs::adapters::find_program(scratch.path().string()).has_value());
  EXPECT_FALSE(orbs::adapters::find_program("").has_value());
}

TEST(Programs, GetTheNamedVariablesOfOursAndALocaleThatWritesPoints) {
  ::setenv("ORBS_TEST_PASSED", "3", 1);
  const auto environment =
      orbs::adapters::child_environment({"ORBS_TEST_PASSED", "ORBS_TEST_ABSENT", "HOME=/h"});
  const auto has = [&](const std::string& entry) {
    return std::count(environment.begin(), environment.end(), entry) == 1;
  };
  EXPECT_TRUE(has("ORBS_TEST_PASSED=3"));
  EXPECT_TRUE(has("HOME=/h"));
  EXPECT_TRUE(has("LC_ALL=C.UTF-8"));
  EXPECT_EQ(std::count_if(environment.begin(), environment.end(),
                          [](const auto& e) { return e.starts_with("HOME="); }),
            1);
}
