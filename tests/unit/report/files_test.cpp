#include "report/files.h"

#include <limits>

#include <gtest/gtest.h>

using namespace orbs::results;

namespace {

RunRecord run_of(Verdict verdict, const std::string& reason) {
  RunRecord run;
  run.suite = "s";
  run.renderers.push_back({});
  run.renderers[0].name = "r";
  run.requirements = {{"M1", "A & B", {{"r", {true, verdict, 41.25, reason}}}}};
  TargetRecord target;
  target.requirement = "M1";
  target.case_name = "m1";
  target.target = "101";
  target.renderer = "r";
  target.declared = true;
  target.jobs = {"id"};
  target.verdict = verdict;
  target.reason = reason;
  target.measures = {{"psnr_srgb8", 41.25, "dB", ""}, {"l1", 0.5, "", ""}};
  run.targets = {target};
  JobRecord job;
  job.identity.id = "id";
  job.cost.started = "2026-01-01T00:00:00";
  job.cost.host.cpu = "a processor";
  job.cost.host.cores = 2;
  job.cost.wall_seconds = 1.5;
  job.cost.cpu_seconds = 2.5;
  job.cost.peak_rss_bytes = 1024;
  run.jobs = {job};
  return run;
}

}  // namespace

TEST(Csv, HasOneRowPerImageAndRenderer) {
  EXPECT_EQ(
      orbs::report::results_csv(run_of(Verdict::Pass, "fine")),
      "suite,size,requirement,case,target,renderer,declared,verdict,expectation,expected,reason,diagnosis,remarks,psnr_srgb8,l1,machine,wall_seconds,cpu_seconds,render_seconds,peak_rss_bytes,image,command\r\n"
      "s,1,M1,m1,101,r,true,pass,none,,fine,,,41.25,0.5,\"a processor, 2 cores\",1.500,2.500,,1024,,\r\n");
}

TEST(Csv, HoldsDiagnosisAndRemarks) {
  auto run = run_of(Verdict::Pass, "fine");
  run.targets[0].diagnosis = "shifted by (2, 1) px: then 60.2 dB";
  run.targets[0].remarks = {"bias: a, b", "c"};
  EXPECT_NE(
      orbs::report::results_csv(run).find(
          ",pass,none,,\"shifted by (2, 1) px: then 60.2 dB; fine\",\"shifted by (2, 1) px: then 60.2 dB\",\"bias: a, b; c\",41.25"),
      std::string::npos);
}

TEST(Csv, QuotesWhatWouldBreakARow) {
  const auto text = orbs::report::results_csv(run_of(Verdict::Fail, "a \"b\", c\nd"));
  EXPECT_NE(text.find(",fail,none,,\"a \"\"b\"\", c\nd\",,,41.25"), std::string::npos) << text;
}
