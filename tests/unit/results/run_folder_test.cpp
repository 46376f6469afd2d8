#include "results/run_folder.h"

#include "base/error.h"
#include "base/files.h"
#include "page/fixture_runs.h"
#include "results/record.h"
#include "structure/source_files.h"

#include <filesystem>
#include <limits>

#include <gtest/gtest.h>
#include <unistd.h>

using namespace orbs;
using namespace orbs::results;

namespace {

JobRecord job_called(const std::string& id, bool done) {
  JobRecord job;
  job.identity.id = id;
  job.identity.scene = id;
  job.identity.renderer = "r";
  job.files.folder = "r/" + id;
  job.end.outcome = done ? JobOutcome::Image : JobOutcome::Skipped;
  return job;
}

TargetRecord target_of(const JobRecord& job) {
  TargetRecord target;
  target.requirement = "M1";
  target.case_name = "c";
  target.target = job.identity.scene;
  target.renderer = job.identity.renderer;
  target.jobs = {job.identity.id};
  target.verdict = verdict_without_image(job.end.outcome).value_or(Verdict::Pass);
  return target;
}

// A run of two renders, the first of which is done.
void write_unfinished(const structure::TestFolder& scratch) {
  RunRecord run;
  run.finished = false;
  for (const char* id : {"a", "b"}) {
    run.jobs.push_back(job_called(id, false));
    run.targets.push_back(target_of(run.jobs.back()));
  }
  scratch.write("results.json", run_json(run));
  const auto done = job_called("a", true);
  scratch.write("r/a/job.json", job_json(done, {target_of(done)}));
}

}  // namespace

TEST(ReadRecord, ReadsBackAllThatWasWritten) {
  const structure::TestFolder scratch("read-record");
  page_tests::write_small_run(scratch.path());
  auto run = read_results_file(scratch.path() / "results.json");
  EXPECT_EQ(run_json(run), read_file(scratch.path() / "results.json"));
  run.targets[0].measures[0].value = std::numeric_limits<double>::infinity();
  run.requirements[0].cells["one"] = {true, Verdict::Pass, std::numeric_limits<double>::infinity(), "s"};
  run.scenes.push_back({"s", "spectral", {{"dispersion", "material 'm'", "has"}}, {{"spectral", "x", "y"}}});
  run.scenes.back().effect_costs.push_back({"polarised", 1.4, 0, "same to the bit"});
  run.finished = false;
  scratch.write("again.json", run_json(run));
  EXPECT_EQ(run_json(read_results_file(scratch.path() / "again.json")), run_json(run));
}

// What a killed or older program left must not pass for a render of today.
TEST(ReadRecord, AnUnknownOutcomeIsNamedWithItsPlace) {
  const structure::TestFolder scratch("read-outcome");
  scratch.write("job.json",
                R"({"format": "orbs-job/2", "identity": {"id": "i", "scene": "s", "renderer": "r"},
 "end": {"outcome": "pass"}})");
  try {
    read_job_file(scratch.path() / "job.json");
    FAIL() << "was read";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("job.json:2:21: /end/outcome: 'pass' is no outcome"),
              std::string::npos)
        << e.what();
  }
}

TEST(ReadRecord, AnUnknownVerdictIsNamedWithItsPlace) {
  const structure::TestFolder scratch("read-verdict");
  scratch.write("results.json", R"({"format": "orbs-results/2",
 "targets": [{"requirement": "M1", "case": "c", "target": "p", "renderer": "r", "verdict": "perfect"}]})");
  try {
    read_results_file(scratch.path() / "results.json");
    FAIL() << "was read";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("results.json:2:"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("'perfect' is no verdict"), std::string::npos) << e.what();
  }
}

TEST(RunFolder, OfARunThatWasKilledKeepsWhatWasDone) {
  const structure::TestFolder scratch("run-killed");
  write_unfinished(scratch);
  const auto view = read_run_folder(scratch.path());
  EXPECT_FALSE(view.is_live);
  EXPECT_EQ(view.run.targets[0].verdict, Verdict::Pass);
  EXPECT_EQ(view.run.targets[1].verdict, Verdict::Skipped);
}

TEST(RunFolder, OfARunThatGoesOnIsFollowed) {
  const structure::TestFolder scratch("run-live");
  write_unfinished(scratch);
  const RunLock lock(scratch.path());
  EXPECT_TRUE(is_running(scratch.path()));
  auto view = read_run_folder(scratch.path());
  EXPECT_TRUE(view.is_live);
  EXPECT_EQ(view.states, (std::vector{JobState::Done, JobState::Waiting}));
  EXPECT_FALSE(refresh(view));
  const WorkFolder work(scratch.path());
  std::filesystem::create_directories(work.path() / "r/b");
  EXPECT_TRUE(refresh(view));
  EXPECT_EQ(view.states[1], JobState::Running);
  scratch.write("r/b/job.json", "{ torn");
  EXPECT_FALSE(refresh(view));
}

// A render in looks leaves its job.json after each of them.
TEST(RunFolder, ARenderInLooksIsReadAgainAfterEachLook) {
  const structure::TestFolder scratch("run-looks");
  write_unfinished(scratch);
  const RunLock lock(scratch.path());
  auto view = read_run_folder(scratch.path());
  auto job = job_called("b", true);
  auto target = target_of(job);
  const auto look = [&](int looks, Verdict verdict, const std::string& end) {
    job.identity.spp = 8 << looks;
    job.sampling = {.looks = looks, .most_looks = 9, .end = end};
    target.verdict = verdict;
    target.looks.push_back({.spp = job.identity.spp, .verdict = verdict, .gate = ""});
    scratch.write("r/b/job.json", job_json(job, {target}));
  };
  look(1, Verdict::Inconclusive, "");
  EXPECT_TRUE(refresh(view));
  EXPECT_EQ(view.states[1], JobState::Running);
  EXPECT_EQ(view.run.targets[1].verdict, Verdict::Inconclusive);
  EXPECT_FALSE(refresh(view));
  look(2, Verdict::Inconclusive, "");
  EXPECT_TRUE(refresh(view));
  EXPECT_EQ(view.states[1], JobState::Running);
  EXPECT_EQ(view.run.jobs[1].identity.spp, 32);
  look(3, Verdict::Fail, "decided");
  EXPECT_TRUE(refresh(view));
  EXPECT_EQ(view.states[1], JobState::Done);
  EXPECT_EQ(view.run.targets[1].verdict, Verdict::Fail);
  EXPECT_EQ(view.run.targets[1].looks.size(), 3U);
  EXPECT_FALSE(refresh(view));
}

// No look follows one that left no image.
TEST(RunFolder, ALookWithoutAnImageEndsTheRender) {
  auto job = job_called("a", true);
  job.sampling.looks = 2;
  EXPECT_TRUE(goes_on(job));
  job.end.outcome = JobOutcome::Crash;
  EXPECT_FALSE(goes_on(job));
  EXPECT_FALSE(goes_on(job_called("a", true)));
}

TEST(RunFolder, TheLockEndsWithItsHolder) {
  const structure::TestFolder scratch("run-lock");
  scratch.write("x", "");
  {
    const RunLock lock(scratch.path());
    try {
      const RunLock second(scratch.path());
      FAIL() << "was locked twice";
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(fmt::format("process {} goes on", ::getpid())), std::string::npos)
          << e.what();
    }
  }
  EXPECT_FALSE(is_running(scratch.path()));
}

TEST(RunFolder, WithoutResultsIsRefused) {
  const structure::TestFolder scratch("run-none");
  scratch.write("x", "");
  EXPECT_THROW(read_run_folder(scratch.path()), InputError);
}
