// Nothing is lost: what is there is kept, what is missing or outdated is done.
#include "base/files.h"
#include "cli/sandbox.h"
#include "results/record.h"
#include "results/run_folder.h"

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::Answer;
using cli_tests::contains;
using cli_tests::replace_in;
using cli_tests::Sandbox;

namespace {

Answer first_run(const Sandbox& sandbox, const std::string& renderers = "good") {
  return sandbox.orbs({"run", "-r", renderers, "-o", "out"});
}

Answer resume(const Sandbox& sandbox) { return sandbox.orbs({"run", "--resume", "out"}); }

// Changes with every render: the time that the file was written.
std::filesystem::file_time_type rendered_at(const Sandbox& sandbox, const std::string& job) {
  return std::filesystem::last_write_time(sandbox.folder() / "out" / job / "result.exr");
}

}  // namespace

TEST(Resume, OfACompleteRunOnlyRebuildsItsResults) {
  const Sandbox sandbox;
  EXPECT_EQ(first_run(sandbox).status, 0);
  const auto before = rendered_at(sandbox, "good/grey");
  const auto job = sandbox.read("out/good/grey/job.json");
  for (const char* file : {"results.json", "results.csv", "junit.xml"})
    std::filesystem::remove(sandbox.folder() / "out" / file);
  const auto answer = resume(sandbox);
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_FALSE(contains(answer.text, "[1/")) << answer.text;
  EXPECT_EQ(rendered_at(sandbox, "good/grey"), before);
  EXPECT_EQ(sandbox.read("out/good/grey/job.json"), job);
  EXPECT_TRUE(results::read_results_file(sandbox.folder() / "out/results.json").finished);
  EXPECT_TRUE(sandbox.has("out/results.csv") && sandbox.has("out/junit.xml"));
}

TEST(Resume, DoesWhatIsMissingAndWhatIsTornAndNothingElse) {
  const Sandbox sandbox;
  first_run(sandbox);
  const auto kept = rendered_at(sandbox, "good/grey");
  std::filesystem::remove_all(sandbox.folder() / "out/good/mirror");
  sandbox.write("out/good/v1.5/job.json", "{ torn");
  const auto answer = resume(sandbox);
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_EQ(rendered_at(sandbox, "good/grey"), kept);
  EXPECT_TRUE(sandbox.has("out/good/mirror/job.json"));
  EXPECT_NO_THROW(results::read_job_file(sandbox.folder() / "out/good/v1.5/job.json"));
}

TEST(Resume, JudgesAgainWhatHasLostItsVerdicts) {
  const Sandbox sandbox;
  first_run(sandbox);
  const auto job = results::read_job_file(sandbox.folder() / "out/good/grey/job.json");
  const auto text = sandbox.read("out/good/grey/job.json");
  const auto from = text.find("\"targets\": [");
  ASSERT_NE(from, std::string::npos);
  sandbox.write("out/good/grey/job.json", text.substr(0, from) + "\"targets\": []\n}\n");
  const auto answer = resume(sandbox);
  EXPECT_EQ(answer.status, 0) << answer.text;
  const auto now = results::read_job_file(sandbox.folder() / "out/good/grey/job.json");
  EXPECT_EQ(now.targets.size(), job.targets.size());
  EXPECT_EQ(now.job.cost.wall_seconds, job.job.cost.wall_seconds);
}

TEST(Resume, RendersAgainWhatCannotBeJudgedForWantOfItsImage) {
  const Sandbox sandbox;
  first_run(sandbox);
  std::filesystem::remove(sandbox.folder() / "out/good/grey/result.exr");
  replace_in(sandbox, "cases/m1_grey/case.json", R"("tests": "t")", R"("tests": "t",
             "gates": [{"metric": "l1", "max": 0.2, "reason": "another"}])");
  const auto answer = resume(sandbox);
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(sandbox.has("out/good/grey/result.exr"));
}

TEST(Resume, RendersAgainWhatHasAnotherSceneOrCommand) {
  const Sandbox sandbox;
  first_run(sandbox, "good,dark");
  const auto kept = rendered_at(sandbox, "dark/mirror");
  replace_in(sandbox, "cases/m1_grey/grey.json", "[0,4,1]", "[0,5,1]");
  replace_in(sandbox, "configuration.json", R"("--mode", "good")", R"("--mode", "complain")");
  const auto answer = resume(sandbox);
  EXPECT_TRUE(contains(answer.text, "dark grey: its scene has changed")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "good mirror: its command, environment or threads")) << answer.text;
  EXPECT_FALSE(contains(answer.text, "dark mirror:")) << answer.text;
  EXPECT_EQ(rendered_at(sandbox, "dark/mirror"), kept);
  EXPECT_TRUE(contains(sandbox.read("out/good/mirror/log.txt"), "something is odd"));
}

TEST(Resume, RendersAgainWhatAnotherVersionOrSeedHasMade) {
  const Sandbox sandbox;
  first_run(sandbox);
  replace_in(sandbox, "out/good/mirror/job.json", "fake renderer 7.8", "fake renderer 7.7");
  replace_in(sandbox, "cases/m1_grey/case.json", R"("file": "grey.json", "spp": 8}])",
             R"("file": "grey.json", "spp": 16}])");
  const auto answer = resume(sandbox);
  EXPECT_TRUE(contains(
      answer.text, "good mirror: it was rendered by 'fake renderer 7.7', now there is 'fake renderer 7.8'"))
      << answer.text;
  EXPECT_TRUE(contains(answer.text, "good v1.5: its samples or its seed have changed")) << answer.text;
  EXPECT_FALSE(contains(answer.text, "good grey:")) << answer.text;
}

TEST(Resume, RendersAgainUnderNewLimitsOnlyWhatHasNoImage) {
  const Sandbox sandbox;
  first_run(sandbox, "good,fill-file");
  const auto kept = rendered_at(sandbox, "good/grey");
  replace_in(sandbox, "configuration.json", R"("limits": {})", R"("limits": {"wall_seconds": 500})");
  replace_in(sandbox, "configuration.json", R"("output_megabytes": 4)", R"("output_megabytes": 5)");
  const auto answer = resume(sandbox);
  EXPECT_TRUE(contains(answer.text, "fill-file grey: its limits have changed")) << answer.text;
  EXPECT_FALSE(contains(answer.text, "good grey:")) << answer.text;
  EXPECT_EQ(rendered_at(sandbox, "good/grey"), kept);
}

TEST(Resume, JudgesAgainWithoutRenderingWhenTheReferenceHasChanged) {
  const Sandbox sandbox;
  first_run(sandbox);
  const auto log = sandbox.read("out/good/grey/log.txt");
  const auto job = results::read_job_file(sandbox.folder() / "out/good/grey/job.json").job;
  std::filesystem::remove(sandbox.folder() / "references/grey.exr");
  EXPECT_EQ(resume(sandbox).status, 1);
  const auto now = results::read_job_file(sandbox.folder() / "out/good/grey/job.json");
  EXPECT_EQ(now.targets.at(0).verdict, results::Verdict::MissingReference);
  EXPECT_EQ(now.job.cost.wall_seconds, job.cost.wall_seconds);
  EXPECT_EQ(sandbox.read("out/good/grey/log.txt"), log);
}

// Times stay those of the machine that they were measured on.
TEST(Resume, OnAnotherMachineKeepsTheHostOfEachRender) {
  const Sandbox sandbox;
  first_run(sandbox);
  const auto cpu = results::read_results_file(sandbox.folder() / "out/results.json").host.cpu;
  ASSERT_NE(cpu, "");
  replace_in(sandbox, "out/good/grey/job.json", cpu, "Another Processor");
  EXPECT_EQ(resume(sandbox).status, 0);
  const auto run = results::read_results_file(sandbox.folder() / "out/results.json");
  EXPECT_EQ(run.host.cpu, cpu);
  for (const auto& job : run.jobs)
    EXPECT_EQ(job.cost.host.cpu, job.identity.scene == "grey" ? "Another Processor" : cpu);
  EXPECT_TRUE(contains(sandbox.read("out/results.csv"), "Another Processor"));
}

TEST(Resume, FinishesWhatAnInterruptLeft) {
  const Sandbox sandbox;
  EXPECT_EQ(first_run(sandbox, "good,interrupt").status, 130);
  replace_in(sandbox, "configuration.json", R"("--mode", "interrupt")", R"("--mode", "good")");
  const auto answer = resume(sandbox);
  EXPECT_EQ(answer.status, 0) << answer.text;
  const auto run = results::read_results_file(sandbox.folder() / "out/results.json");
  EXPECT_FALSE(run.interrupted);
  EXPECT_EQ(run.jobs.size(), 6U);
}

TEST(Resume, TakesTheSettingsOfTheRunAndRefusesOtherChoices) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "good", "-s", "grey", "--seed", "5", "-o", "out"});
  std::filesystem::remove_all(sandbox.folder() / "out/good");
  EXPECT_EQ(resume(sandbox).status, 0);
  EXPECT_EQ(results::read_job_file(sandbox.folder() / "out/good/grey/job.json").job.identity.seed, 5);
  EXPECT_FALSE(sandbox.has("out/good/mirror"));
  EXPECT_EQ(sandbox.orbs({"run", "--resume", "out", "-s", "mirror"}).status, 2);
}

TEST(Resume, OfWhatIsNoRunIsRefused) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "--resume", "cases"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "holds no run.json")) << answer.text;
}

TEST(Resume, OfARunThatGoesOnIsRefusedWithItsProcess) {
  const Sandbox sandbox;
  first_run(sandbox);
  const results::RunLock lock(sandbox.folder() / "out");
  const auto answer = resume(sandbox);
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "a run of process " + std::to_string(::getpid()) + " goes on"))
      << answer.text;
}

// A log beyond what fits stands for the full disk: the renderer itself has no trouble. The first results.json
// of this run has less than the 100 kB.
TEST(Resume, AFullDiskIsToldLeavesNothingHalfAndNothingIsLost) {
  const Sandbox sandbox;
  const auto answer =
      sandbox.orbs_with_small_files({"run", "-r", "good,much", "-s", "grey", "-o", "out"}, 100000);
  EXPECT_EQ(answer.status, 2) << answer.text;
  EXPECT_TRUE(contains(answer.text, "log.txt: cannot be written: File too large")) << answer.text;
  EXPECT_TRUE(contains(answer.text, " run --resume ")) << answer.text;
  EXPECT_TRUE(sandbox.has("out/good/grey/job.json"));
  EXPECT_FALSE(sandbox.has("out/much/grey")) << "half a result";
  EXPECT_FALSE(sandbox.has("out/.unfinished"));
  EXPECT_FALSE(results::read_results_file(sandbox.folder() / "out/results.json").finished);
  EXPECT_EQ(resume(sandbox).status, 0);
  EXPECT_TRUE(sandbox.has("out/much/grey/job.json"));
}
