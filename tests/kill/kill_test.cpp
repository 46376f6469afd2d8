// A hundred times kill -9 at a random moment of a run, then --resume: every result is there, none twice, none
// torn. Its renderer is a shell script that copies an image, so that the harness's own work is what is hit.
#include "base/files.h"
#include "cli/sandbox.h"
#include "results/record.h"

#include <chrono>
#include <iostream>
#include <random>
#include <set>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace orbs;
using cli_tests::Sandbox;

namespace {

constexpr int kKills = 100;
constexpr int kScenes = 8;

std::string scene_name(int number) { return fmt::format("s{}", number); }

void write_suite(const Sandbox& sandbox) {
  std::string scenes;
  for (int i = 0; i < kScenes; ++i) {
    scenes += fmt::format(R"({}{{"name": "{}", "file": "grey.json", "spp": 8}})", i == 0 ? "" : ", ",
                          scene_name(i));
    std::filesystem::copy_file(sandbox.folder() / "references/grey.exr",
                               sandbox.folder() / "references" / (scene_name(i) + ".exr"));
  }
  std::filesystem::remove_all(sandbox.folder() / "cases/m3_mirror");
  sandbox.write(
      "cases/m1_grey/case.json",
      fmt::format(
          R"({{"format": "orbs-case/2", "requirement": "M1", "title": "t", "tests": "t", "typical_mistake": "m", "scenes": [{}]}})",
          scenes));
  sandbox.write("copy.sh", "#!/bin/sh\nexec cp \"$1\" \"$2\"\n");
  ::chmod((sandbox.folder() / "copy.sh").c_str(), 0755);
  sandbox.write(
      "configuration.json",
      R"({"format": "orbs-configuration/1", "stands_alone": true, "defaults": {"suite": "t", "jobs": 2},
 "suites": [{"name": "t", "cases": "cases", "references": "references"}],
 "renderers": [{"name": "copy", "executable": "{root}/copy.sh", "declares": "G5/M8",
                "command": ["{executable}", "{root}/references/grey.exr", "{output}", "{scene}"]}]})");
}

// Starts orbs on the folder "out", new or not, and kills it after that time unless it has ended by itself.
// True when it was killed.
bool run_and_kill(const Sandbox& sandbox, int after_ms) {
  const bool is_new = !sandbox.has("out/run.json");
  if (is_new) std::filesystem::remove_all(sandbox.folder() / "out");
  const pid_t pid = ::fork();
  if (pid == 0) {
    const int nothing = ::open("/dev/null", O_WRONLY);
    ::dup2(nothing, STDOUT_FILENO);
    ::dup2(nothing, STDERR_FILENO);
    if (::chdir(sandbox.folder().c_str()) == 0)
      ::execl(ORBS_BINARY_DIR "/orbs", "orbs", "run", is_new ? "-o" : "--resume", "out", nullptr);
    ::_exit(127);
  }
  const int watch = static_cast<int>(::syscall(SYS_pidfd_open, pid, 0));
  pollfd ended{watch, POLLIN, 0};
  const bool has_ended = ::poll(&ended, 1, after_ms) > 0;
  if (!has_ended) ::kill(pid, SIGKILL);
  int status = 0;
  ::waitpid(pid, &status, 0);
  ::close(watch);
  EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0) << WEXITSTATUS(status);
  return WIFSIGNALED(status);
}

// How many renders are in their places; each that is must be whole.
int whole_renders(const Sandbox& sandbox, const std::string& image) {
  int count = 0;
  for (int i = 0; i < kScenes; ++i) {
    const auto folder = "out/copy/" + scene_name(i);
    if (!sandbox.has(folder)) continue;
    ++count;
    const auto file = results::read_job_file(sandbox.folder() / folder / "job.json");
    EXPECT_EQ(file.job.identity.scene, scene_name(i));
    EXPECT_EQ(file.targets.size(), 1U);
    EXPECT_EQ(sandbox.read(folder + "/result.exr"), image);
    EXPECT_TRUE(sandbox.has(folder + "/result.png"));
  }
  return count;
}

void expect_complete(const Sandbox& sandbox, const std::string& image) {
  EXPECT_EQ(whole_renders(sandbox, image), kScenes);
  const auto run = results::read_results_file(sandbox.folder() / "out/results.json");
  EXPECT_TRUE(run.finished);
  std::set<std::string> jobs;
  std::set<std::string> images;
  for (const auto& job : run.jobs)
    EXPECT_TRUE(jobs.insert(job.identity.id).second) << "twice: " << job.identity.scene;
  for (const auto& one : run.targets) {
    EXPECT_TRUE(images.insert(one.target).second) << "twice: " << one.target;
    EXPECT_EQ(one.verdict, results::Verdict::Pass) << one.reason;
  }
  EXPECT_EQ(jobs.size(), kScenes);
  EXPECT_EQ(images.size(), kScenes);
  EXPECT_FALSE(sandbox.has("out/.unfinished"));
  EXPECT_FALSE(sandbox.has("out/run.lock"));
}

}  // namespace

TEST(Kill, AHundredTimesAtRandomMomentsLosesNothing) {
  const Sandbox sandbox;
  write_suite(sandbox);
  const auto image = sandbox.read("references/grey.exr");
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_FALSE(run_and_kill(sandbox, 60000));
  const auto whole_ms =
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begin).count();
  expect_complete(sandbox, image);
  std::filesystem::remove_all(sandbox.folder() / "out");
  std::mt19937 random(1);
  std::uniform_int_distribution<int> moment(0, static_cast<int>(whole_ms));
  int kills = 0;
  int complete = 0;
  int kept = 0;
  while (kills < kKills && !HasFailure()) {
    if (run_and_kill(sandbox, moment(random))) {
      ++kills;
      kept += whole_renders(sandbox, image);
    } else {
      ++complete;
      expect_complete(sandbox, image);
      std::filesystem::remove_all(sandbox.folder() / "out");
    }
  }
  run_and_kill(sandbox, 60000);
  expect_complete(sandbox, image);
  std::cout << fmt::format(
      "{} kills; {} whole renders were found after them, none torn; {} runs of {} renders were "
      "completed, none with one missing or twice\n",
      kills, kept, complete + 1, kScenes);
}
