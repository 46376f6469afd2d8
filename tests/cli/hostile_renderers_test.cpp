// Renderers that harm what lies around their folder lose their own render, and nothing else is lost.
#include "cli/sandbox.h"
#include "results/record.h"

#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

using namespace orbs;
using cli_tests::Answer;
using cli_tests::contains;
using cli_tests::Sandbox;

namespace {

namespace fs = std::filesystem;

// A renderer that leaves its image and does as the lines of the shell say: $root is the sandbox's folder, and
// it is in the folder of its render.
Answer run_hostile(const Sandbox& sandbox, const std::string& lines) {
  sandbox.write("hostile",
                fmt::format("#!/bin/sh\nroot={}\n{}/orbs-fake-renderer \"$@\" || exit\n{}\nexit 0\n",
                            sandbox.folder().string(), ORBS_BINARY_WORD, lines));
  ::chmod((sandbox.folder() / "hostile").c_str(), 0755);
  return sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-e", "./hostile", "-o", "out", "-j", "1"});
}

results::JobFile job_of(const Sandbox& sandbox, const std::string& scene) {
  return results::read_job_file(sandbox.folder() / "out/good" / scene / "job.json");
}

}  // namespace

TEST(HostileRenderers, ThatReplaceTheFolderAboveLoseTheirOwnRender) {
  for (const char* above : {"../", "../../"})
    for (const char* replacement : {"ln -s /nowhere/at/all", "ln -s $root/elsewhere", "cp $root/hostile"}) {
      const Sandbox sandbox;
      fs::create_directories(sandbox.folder() / "elsewhere/grey");
      const auto answer = run_hostile(
          sandbox,
          fmt::format(
              "case \"$PWD\" in */grey) folder=$(cd {0} && pwd); mv $folder $root/moved; {1} $folder;; esac",
              above, replacement));
      const auto what = fmt::format("{} {}: {}", above, replacement, answer.text);
      EXPECT_EQ(answer.status, 1) << what;
      ASSERT_TRUE(sandbox.has("out/good/v1.5/job.json")) << what;
      EXPECT_EQ(job_of(sandbox, "v1.5").targets.at(0).verdict, results::Verdict::Pass) << what;
      const auto lost = job_of(sandbox, "grey").job;
      EXPECT_EQ(lost.end.outcome, results::JobOutcome::NoOutput) << what;
      EXPECT_TRUE(contains(lost.end.reason, "put something else in the place of its folder, or of one above"))
          << lost.end.reason;
      EXPECT_TRUE(sandbox.has("out/good/grey/log.txt")) << what;
      EXPECT_TRUE(fs::is_empty(sandbox.folder() / "elsewhere/grey")) << "we wrote where the link leads";
    }
}

// What is written where finished renders lie is no place for others.
TEST(HostileRenderers, ThatReplaceTheFolderOfResultsHarmNobody) {
  const Sandbox sandbox;
  fs::create_directories(sandbox.folder() / "elsewhere");
  const auto answer = run_hostile(sandbox, "test -e $root/out/good || ln -s $root/elsewhere $root/out/good");
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_FALSE(fs::is_symlink(sandbox.folder() / "out/good"));
  EXPECT_TRUE(fs::is_empty(sandbox.folder() / "elsewhere")) << "we wrote where the link leads";
}

TEST(HostileRenderers, ThatEditTheirSceneLoseTheirOwnRender) {
  for (const char* file : {"scene.json", "$root/cases/m1_grey/grey.json"}) {
    const Sandbox sandbox;
    const auto answer = run_hostile(
        sandbox,
        fmt::format("case \"$PWD\" in */grey) touch -r {0} before; echo >> {0}; touch -r before {0};; esac",
                    file));
    EXPECT_EQ(answer.status, 1) << answer.text;
    const auto lost = job_of(sandbox, "grey").job;
    EXPECT_EQ(lost.end.outcome, results::JobOutcome::Stale) << file;
    EXPECT_TRUE(contains(lost.end.reason, "which its scene is made of, has changed while it was rendered"))
        << lost.end.reason;
    EXPECT_EQ(job_of(sandbox, "v1.5").targets.at(0).verdict, results::Verdict::Pass) << answer.text;
  }
}
