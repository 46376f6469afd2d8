#include "base/error.h"
#include "json/document.h"
#include "results/record.h"
#include "structure/source_files.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

using namespace orbs::results;

namespace {

TargetRecord target(Verdict verdict, bool declared) {
  TargetRecord record;
  record.verdict = verdict;
  record.declared = declared;
  return record;
}

}  // namespace

TEST(Verdicts, AreOrderedFromBestToWorst) {
  EXPECT_EQ(worse(Verdict::Pass, Verdict::Unsupported), Verdict::Unsupported);
  EXPECT_EQ(worse(Verdict::Fail, Verdict::Unsupported), Verdict::Fail);
  EXPECT_EQ(worse(Verdict::Fail, Verdict::Crash), Verdict::Crash);
}

TEST(Verdicts, OnlyAPassAndWhatWasNeverPromisedAreNoFailure) {
  for (const auto verdict : kVerdicts)
    EXPECT_EQ(counts_as_failure(verdict), !passes(verdict) && verdict != Verdict::Unsupported)
        << verdict_name(verdict);
}

TEST(Verdicts, HaveDifferentNames) {
  for (const auto a : kVerdicts)
    for (const auto b : kVerdicts) EXPECT_EQ(a == b, verdict_name(a) == verdict_name(b));
}

TEST(JobOutcomes, OtherThanAnImageAreVerdictsOfTheSameName) {
  for (const auto outcome : kJobOutcomes) {
    const auto verdict = verdict_without_image(outcome);
    EXPECT_EQ(verdict.has_value(), outcome != JobOutcome::Image);
    EXPECT_EQ(job_outcome_name(outcome), verdict ? verdict_name(*verdict) : "image");
    EXPECT_EQ(job_outcome_named(job_outcome_name(outcome)), outcome);
  }
  EXPECT_EQ(job_outcome_named("pass"), std::nullopt);
}

TEST(ExitStatus, IsOneForEveryFailureOnWhatARendererDeclares) {
  RunRecord run;
  run.targets = {target(Verdict::Pass, true), target(Verdict::Unsupported, true),
                 target(Verdict::Fail, false)};
  EXPECT_EQ(exit_status(run), 0);
  run.targets.push_back(target(Verdict::MissingReference, true));
  EXPECT_EQ(exit_status(run), 1);
}

TEST(ExitStatus, IsTwoWhereNothingWasJudged) {
  RunRecord run;
  EXPECT_EQ(exit_status(run), 2);
  run.targets = {target(Verdict::Unsupported, true), target(Verdict::Unsupported, false)};
  EXPECT_EQ(exit_status(run), 2);
  run.targets.push_back(target(Verdict::Crash, true));
  EXPECT_EQ(exit_status(run), 1);
}

TEST(ResultsJson, KeepsAllThatIsKnownOfTheMachines) {
  const orbs::structure::TestFolder scratch("results-host");
  Host host{"n", "c", 4, "performance", 1000, "s", "d", "g++", 1.5, 2000};
  RunRecord run;
  run.host = host;
  run.load = 0.75;
  run.jobs.resize(2);
  for (auto& job : run.jobs) {
    job.cost.started = "2026-01-01T00:00:00";
    job.cost.host = host;
  }
  run.jobs[1].cost.host.cpu_limit_cores.reset();
  run.jobs[1].cost.load = 3.5;
  scratch.write("results.json", run_json(run));
  const auto read = read_results_file(scratch.path() / "results.json");
  EXPECT_EQ(read.host, host);
  EXPECT_EQ(read.load, 0.75);
  EXPECT_EQ(read.jobs[0].cost.host, host);
  EXPECT_EQ(read.jobs[1].cost.host, run.jobs[1].cost.host);
  EXPECT_EQ(read.jobs[1].cost.load, 3.5);
  scratch.write("job.json", job_json(run.jobs[1], {}));
  EXPECT_EQ(read_job_file(scratch.path() / "job.json").job.cost.host, run.jobs[1].cost.host);
}

TEST(ResultsJson, KeepsTheLooksOfATargetAndOfItsRender) {
  const orbs::structure::TestFolder scratch("results-looks");
  RunRecord run;
  run.targets.push_back(target(Verdict::Pass, true));
  run.targets[0].looks = {{.spp = 16, .verdict = Verdict::Inconclusive, .gate = ""},
                          {.spp = 32,
                           .verdict = Verdict::Pass,
                           .gate = "mean_ratio_g",
                           .value = 0.001,
                           .low = -0.0025,
                           .high = 0.0045}};
  run.jobs.emplace_back();
  run.jobs[0].identity.spp = 32;
  run.jobs[0].sampling = {.looks = 2, .most_looks = 9, .end = "decided"};
  const auto expect_looks = [](const TargetRecord& target, const JobRecord& job) {
    ASSERT_EQ(target.looks.size(), 2U);
    EXPECT_EQ(target.looks[0].spp, 16);
    EXPECT_EQ(target.looks[0].verdict, Verdict::Inconclusive);
    EXPECT_EQ(target.looks[0].gate, "");
    EXPECT_EQ(target.looks[0].value, std::nullopt);
    EXPECT_EQ(target.looks[1].spp, 32);
    EXPECT_EQ(target.looks[1].verdict, Verdict::Pass);
    EXPECT_EQ(target.looks[1].gate, "mean_ratio_g");
    EXPECT_EQ(target.looks[1].value, 0.001);
    EXPECT_EQ(target.looks[1].low, -0.0025);
    EXPECT_EQ(target.looks[1].high, 0.0045);
    EXPECT_EQ(job.sampling.looks, 2);
    EXPECT_EQ(job.sampling.most_looks, 9);
    EXPECT_EQ(job.sampling.end, "decided");
  };
  scratch.write("results.json", run_json(run));
  const auto read = read_results_file(scratch.path() / "results.json");
  expect_looks(read.targets.at(0), read.jobs.at(0));
  scratch.write("job.json", job_json(run.jobs[0], run.targets));
  const auto of_job = read_job_file(scratch.path() / "job.json");
  expect_looks(of_job.targets.at(0), of_job.job);
}

// Records of an orbs that knew no looks.
TEST(ResultsJson, WithoutLooksTheSamplesWereFixed) {
  const orbs::structure::TestFolder scratch("results-no-looks");
  scratch.write("job.json",
                R"({"format": "orbs-job/2", "identity": {"id": "i", "scene": "s", "renderer": "r"},
 "end": {"outcome": "image"},
 "targets": [{"requirement": "M1", "case": "c", "target": "s", "renderer": "r", "verdict": "pass"}]})");
  const auto read = read_job_file(scratch.path() / "job.json");
  EXPECT_EQ(read.job.sampling.looks, 0);
  EXPECT_EQ(read.job.sampling.end, "");
  EXPECT_TRUE(read.targets.at(0).looks.empty());
}

TEST(JobJson, RefusesCountsThatNoRenderCanHave) {
  const orbs::structure::TestFolder scratch("results-counts");
  const auto file = scratch.path() / "job.json";
  const std::string whole = job_json({}, {});
  const std::vector<std::array<std::string, 3>> damaged{
      {R"("spp": 1)", R"("spp": 0)", "/identity/spp: must lie in [1, 2147483647], is 0"},
      {R"("seeds": 1)", R"("seeds": -2)", "/identity/seeds: must lie in [1, 2147483647], is -2"},
      {R"("threads": 0)", R"("threads": -1)", "/program/threads: must lie in [0, 2147483647], is -1"},
      {R"("peak_rss_bytes": 0)", R"("peak_rss_bytes": 0.5)",
       "/cost/peak_rss_bytes: must be a whole number, is 0.5"}};
  for (const auto& [right, wrong, complaint] : damaged) {
    auto text = whole;
    const auto at = text.find(right);
    ASSERT_NE(at, std::string::npos) << right << " in " << whole;
    text.replace(at, right.size(), wrong);
    scratch.write("job.json", text);
    const auto line =
        std::to_string(1 + std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
    try {
      read_job_file(file);
      ADD_FAILURE() << wrong << " was read";
    } catch (const orbs::InputError& e) {
      EXPECT_NE(std::string(e.what()).find(complaint), std::string::npos) << e.what();
      EXPECT_EQ(std::string(e.what()).find(file.string() + ":" + line + ":"), 0U) << e.what();
    }
  }
}

// Folders of runs come from other machines.
TEST(JobJson, RefusesPathsThatLeadElsewhere) {
  const orbs::structure::TestFolder scratch("results-paths");
  for (const char* path : {"..", "../x", "a/../../x", "/etc/passwd"}) {
    JobRecord job;
    job.files.image = path;
    TargetRecord target;
    target.maps = {{"l1", path, "", false, 1}};
    for (const auto& text : {job_json(job, {}), job_json({}, {target})}) {
      scratch.write("job.json", text);
      try {
        read_job_file(scratch.path() / "job.json");
        ADD_FAILURE() << path << " was read";
      } catch (const orbs::InputError& e) {
        EXPECT_NE(std::string(e.what()).find("leads out of the folder"), std::string::npos) << e.what();
      }
    }
  }
}

TEST(ResultsJson, IsJsonWhateverTheTextsHold) {
  RunRecord run;
  run.suite = "a \"quoted\" \x01 \xff suite\n";
  run.targets.push_back(target(Verdict::Pass, true));
  run.targets[0].measures.push_back({"psnr_srgb8", std::numeric_limits<double>::infinity(), "dB", "d"});
  run.jobs.emplace_back();
  run.requirements.push_back({"M1", "t", {{"r", Cell{}}}});
  const auto text = run_json(run);
  EXPECT_NO_THROW(orbs::json::parse("results.json", text));
  EXPECT_NE(text.find("\"value\": null,\n          \"infinite\": true"), std::string::npos) << text;
}
