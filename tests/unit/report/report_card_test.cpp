// What a stranger reads first of a renderer, for made-up runs.
#include "report/report_card.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

using namespace orbs::results;
using namespace orbs::report;

namespace {

TargetRecord judged(const std::string& name, Verdict verdict, const std::string& diagnosis = "") {
  TargetRecord target;
  target.renderer = "mine";
  target.target = name;
  target.declared = true;
  target.verdict = verdict;
  target.diagnosis = diagnosis;
  return target;
}

RunRecord run_of(std::vector<TargetRecord> targets) {
  RunRecord run;
  run.renderers = {{"mine", "", "", "", "", "", {}, 0, 0}};
  run.targets = std::move(targets);
  return run;
}

ReportCard card_of(std::vector<TargetRecord> targets) {
  return report_cards(run_of(std::move(targets))).front();
}

// A render in looks, with its squared noise times its CPU seconds.
void add_work(RunRecord& run, const std::string& renderer, const std::string& target, double cpu_seconds) {
  auto record = judged(target, Verdict::Pass);
  record.renderer = renderer;
  record.jobs = {renderer + target};
  record.measures = {{"noise_squared", 0.01, "", "", true}};
  run.targets.push_back(record);
  JobRecord job;
  job.identity.id = renderer + target;
  job.sampling.looks = 2;
  job.cost.cpu_seconds = cpu_seconds;
  run.jobs.push_back(job);
}

}  // namespace

TEST(ReportCard, ARightRendererIsRight) {
  const auto card = card_of({judged("a", Verdict::Pass), judged("b", Verdict::PassWithRemarks)});
  EXPECT_EQ(card.standing, "right");
  EXPECT_EQ(card.sentence, "right on all 2 targets; 1 with remarks");
}

// The numbers of the fault differ from image to image.
TEST(ReportCard, FailuresAreGroupedByTheirDiagnosis) {
  const auto card =
      card_of({judged("a", Verdict::Fail, "multiplied by 3.14: then 60.1 dB"),
               judged("b", Verdict::Fail, "multiplied by pi: then 58 dB"),
               judged("e", Verdict::Fail, "multiplied by pi: then 59 dB"),
               judged("c", Verdict::Fail, std::string(kNoUsualFault)), judged("d", Verdict::Pass)});
  EXPECT_EQ(card.standing, "wrong");
  EXPECT_EQ(card.sentence, "wrong in 4 of 5 targets: in 3 of them multiplied by pi");
  ASSERT_EQ(card.groups.size(), 2U);
  EXPECT_EQ(card.groups[0].targets, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_TRUE(card.groups[0].is_diagnosis);
  EXPECT_EQ(card.groups[1].what, kNoUsualFault);
}

TEST(ReportCard, AFaultOfFewIsNoCauseOfAll) {
  const auto none = std::string(kNoUsualFault);
  const auto card = card_of({judged("a", Verdict::Fail, "mirrored: then 60.1 dB"),
                             judged("b", Verdict::Fail, none), judged("c", Verdict::Fail, none)});
  EXPECT_EQ(card.sentence, "wrong in 3 of 3 targets");
}

// A missing lamp is no usual fault, but all images are too dark.
TEST(ReportCard, WithoutADiagnosisItSaysHowMuchLightIsMissing) {
  const auto darker = [](const std::string& name, double by) {
    auto target = judged(name, Verdict::Fail, std::string(kNoUsualFault));
    for (const char* channel : {"mean_ratio_r", "mean_ratio_g", "mean_ratio_b"})
      target.measures.push_back({channel, -by, "1", "", false, true, -by - 0.01, -by + 0.01});
    return target;
  };
  EXPECT_EQ(card_of({darker("a", 0.24), darker("b", 0.5)}).sentence,
            "wrong in 2 of 2 targets: too dark by 24 to 50 %");
  EXPECT_EQ(card_of({darker("a", 0.24), darker("b", -0.5)}).sentence, "wrong in 2 of 2 targets");
  EXPECT_EQ(card_of({darker("a", 0.24), darker("b", 0.005)}).sentence, "wrong in 2 of 2 targets");
}

TEST(ReportCard, WhatIsKnownOrOpenIsSaidApart) {
  auto known = judged("a", Verdict::Fail);
  known.expectation = Expectation::Known;
  known.expected = "another Oren-Nayar; better than configuration.json:7 accepts: accept it anew";
  auto open = judged("b", Verdict::Inconclusive);
  open.reason = "undecided: its noise: about 4 times the samples would decide it; R is 1 % darker";
  const auto card = card_of({known, open, judged("c", Verdict::Pass)});
  EXPECT_EQ(card.standing, "undecided");
  EXPECT_EQ(card.sentence, "wrong in 1 of 3 targets, all of them known; 1 undecided");
  ASSERT_EQ(card.groups.size(), 2U);
  EXPECT_EQ(card.groups[0].what, "undecided because of its noise");
  EXPECT_EQ(card.groups[1].what, "another Oren-Nayar");
  EXPECT_EQ(card_of({open, judged("c", Verdict::Pass)}).sentence, "right on 1 of 2 targets; 1 undecided");
  EXPECT_EQ(card_of({open}).sentence, "nothing is decided; 1 undecided");
}

TEST(ReportCard, WithoutAnImageItIsWrong) {
  const auto card = card_of({judged("a", Verdict::Crash), judged("b", Verdict::Pass)});
  EXPECT_EQ(card.standing, "wrong");
  EXPECT_EQ(card.sentence, "no image of 1 of 2 targets");
}

// An unsupported or undeclared requirement is nothing that the renderer got wrong, or right.
TEST(ReportCard, OnlyWhatItDeclaresCounts) {
  auto undeclared = judged("b", Verdict::Fail);
  undeclared.declared = false;
  EXPECT_EQ(card_of({judged("a", Verdict::Unsupported), undeclared}).sentence,
            "nothing that it declares was asked of it");
  EXPECT_EQ(card_of({judged("a", Verdict::Skipped)}).standing, "open");
}

// Four targets, of which each takes 2 to 4 times as long: sqrt(8) on average.
TEST(ReportCard, EqualNoiseHasItsCost) {
  RunRecord run;
  run.renderers = {{"fast", "", "", "", "", "", {}, 0, 0}, {"slow", "", "", "", "", "", {}, 0, 0}};
  for (const auto& [name, factor] : {std::pair{"a", 2.0}, {"b", 4.0}, {"c", 2.0}, {"d", 4.0}}) {
    add_work(run, "fast", name, 10);
    add_work(run, "slow", name, 10 * factor);
  }
  const auto cards = report_cards(run);
  EXPECT_FALSE(cards[0].cost);
  ASSERT_TRUE(cards[1].cost);
  EXPECT_NEAR(cards[1].cost->ratio, std::sqrt(8), 1e-9);
  // Student's 3.182 with 3 degrees of freedom times ln(2) / 2 sqrt(4 / 3) / 2.
  EXPECT_NEAR(std::log(cards[1].cost->high / cards[1].cost->ratio), 3.1824 * std::log(2) / 2 / std::sqrt(3),
              1e-4);
  EXPECT_EQ(cards[1].cost->sentence,
            "takes 2.8 times the CPU time of fast for equal noise (1.5 to 5.3, 4 targets)");
}
