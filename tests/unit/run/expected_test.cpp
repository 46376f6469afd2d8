// Known failures against the verdicts of a run.
#include "run/expected.h"

#include <limits>
#include <utility>

#include <gtest/gtest.h>

using namespace orbs;
using results::Expectation;
using results::Verdict;

namespace {

registry::ExpectedFailure fails_by_psnr() {
  registry::ExpectedFailure entry;
  entry.place = "configuration.json:7";
  entry.renderer = "r";
  entry.scene = "s";
  entry.verdict = "fail";
  entry.reason = "known";
  entry.measure = {{"psnr_srgb8", 30}};
  return entry;
}

results::TargetRecord failed(double psnr_db, bool meets_the_gate) {
  results::TargetRecord target;
  target.renderer = "r";
  target.target = "s";
  target.declared = true;
  target.verdict = Verdict::Fail;
  target.measures = {{"psnr_srgb8", psnr_db, "dB", ""}};
  target.checks = {{.what = "psnr_srgb8", .passed = meets_the_gate, .reason = "", .min = 35, .max = {}}};
  return target;
}

constexpr registry::SizeDivisor kSize = registry::FullSize;

results::TargetRecord marked(results::TargetRecord target,
                             const registry::ExpectedFailure& entry,
                             const std::string& day = "2026-11-25") {
  std::vector<results::TargetRecord> targets{std::move(target)};
  run::mark_expected({entry}, {"suite", kSize, day}, {{"r", "1"}}, targets);
  return targets.front();
}

Expectation expectation_of(const results::TargetRecord& target, const registry::ExpectedFailure& entry) {
  return marked(target, entry).expectation;
}

registry::ExpectedFailure fails_by_light(double accepted) {
  auto entry = fails_by_psnr();
  entry.measure = {{"mean_ratio_r", accepted}};
  return entry;
}

// Whose mean of R is off by `light`, known to +-`half`.
results::TargetRecord off_by(double light, double half) {
  auto target = failed(30, false);
  target.measures = {
      {.name = "mean_ratio_r", .value = light, .unit = "1", .definition = "", .is_signed = true}};
  target.measures[0].low = light - half;
  target.measures[0].high = light + half;
  target.checks = {{.what = "mean_ratio_r", .passed = false, .reason = "", .min = -0.007, .max = 0.007}};
  return target;
}

}  // namespace

TEST(ExpectedVerdicts, AFailureLikeTheRecordedOneIsKnown) {
  EXPECT_EQ(expectation_of(failed(30, false), fails_by_psnr()), Expectation::Known);
  EXPECT_EQ(expectation_of(failed(20, false), fails_by_psnr()), Expectation::News);
}

// A run with a smaller budget took fewer samples.
TEST(ExpectedVerdicts, AFailureThatNoiseLeavesOpenIsKnown) {
  auto target = failed(20, false);
  target.verdict = Verdict::Inconclusive;
  target.checks[0].decided = false;
  EXPECT_EQ(expectation_of(target, fails_by_psnr()), Expectation::Known);
  target = off_by(-0.02, 0.015);
  target.verdict = Verdict::Inconclusive;
  target.checks[0].decided = false;
  EXPECT_EQ(expectation_of(target, fails_by_light(-0.015)), Expectation::Known);
  EXPECT_EQ(expectation_of(target, fails_by_light(0.015)), Expectation::News) << "it is on the other side";
  auto entry = fails_by_light(-0.015);
  entry.verdict = "inconclusive";
  target.verdict = Verdict::Fail;
  EXPECT_EQ(expectation_of(target, entry), Expectation::News);
}

// The radiosity of POV-Ray depends on which thread comes first.
TEST(ExpectedVerdicts, ToleranceIsForRenderersOfWhichTwoRunsDiffer) {
  auto entry = fails_by_psnr();
  EXPECT_EQ(expectation_of(failed(29.5, false), entry), Expectation::News);  // 12 % more error
  entry.tolerance = 0.25;
  EXPECT_EQ(expectation_of(failed(29.5, false), entry), Expectation::Known);
  EXPECT_EQ(expectation_of(failed(28.9, false), entry), Expectation::News);  // 29 %
}

// As a copy of the reference does.
TEST(ExpectedVerdicts, AFailureThatMeetsEveryCheckIsNews) {
  auto any = fails_by_psnr();
  any.measure.clear();
  for (const auto& entry : {fails_by_psnr(), any})
    EXPECT_EQ(expectation_of(failed(90, true), entry), Expectation::News);
}

TEST(ExpectedVerdicts, ANumberThatIsNoneIsNews) {
  EXPECT_EQ(expectation_of(failed(std::numeric_limits<double>::quiet_NaN(), false), fails_by_psnr()),
            Expectation::News);
}

TEST(ExpectedVerdicts, TheOtherSideOfTheRightNumberIsNews) {
  EXPECT_EQ(expectation_of(off_by(0.051, 0.002), fails_by_light(0.051)), Expectation::Known);
  const auto other = marked(off_by(-0.049, 0.002), fails_by_light(0.051));
  EXPECT_EQ(other.expectation, Expectation::News);
  EXPECT_EQ(
      other.expected,
      "R is 4.9 % darker, wrong to the other side than 5.1 % brighter, the failure that configuration.json:7 "
      "accepts");
  // Where noise leaves it open on which side the number lies, nothing is new.
  auto open = off_by(-0.002, 0.03);
  open.verdict = Verdict::Inconclusive;
  open.checks[0].decided = false;
  auto entry = fails_by_light(0.01);
  entry.verdict = "inconclusive";
  EXPECT_EQ(expectation_of(open, entry), Expectation::Known);
}

TEST(ExpectedVerdicts, AnErrorThatIsWorseThanAcceptedByMoreThanNoiseIsNews) {
  const auto worse = marked(off_by(0.08, 0.002), fails_by_light(0.051));
  EXPECT_EQ(worse.expectation, Expectation::News);
  EXPECT_EQ(
      worse.expected,
      "R is 8 % brighter, which is worse than 5.1 % brighter, the failure that configuration.json:7 accepts");
  EXPECT_EQ(expectation_of(off_by(0.056, 0.002), fails_by_light(0.051)), Expectation::News);
  // Within sqrt(2) half intervals, and within a twentieth of the error.
  EXPECT_EQ(expectation_of(off_by(0.08, 0.03), fails_by_light(0.051)), Expectation::Known);
  EXPECT_EQ(expectation_of(off_by(0.053, 0), fails_by_light(0.051)), Expectation::Known);
  EXPECT_EQ(expectation_of(failed(29.9, false), fails_by_psnr()), Expectation::Known);
  EXPECT_EQ(expectation_of(failed(29, false), fails_by_psnr()), Expectation::News);
}

TEST(ExpectedVerdicts, TheNoiseOfAPsnrIsThatOfItsError) {
  auto noisy = failed(29, false);
  noisy.measures.push_back({"mse", 1e-3, "radiance^2", ""});
  noisy.measures.push_back({"bias_squared", 5e-4, "radiance^2", ""});
  noisy.measures.back().low = 2e-4;
  noisy.measures.back().high = 8e-4;
  EXPECT_EQ(expectation_of(noisy, fails_by_psnr()), Expectation::Known);
  EXPECT_EQ(expectation_of(failed(29, false), fails_by_psnr()), Expectation::News);
  noisy.measures[0].value = 25;
  EXPECT_EQ(expectation_of(noisy, fails_by_psnr()), Expectation::News);
}

TEST(ExpectedVerdicts, WhatIsBetterThanAcceptedIsKnownAndSaysSo) {
  const auto mended = marked(off_by(0.02, 0.002), fails_by_light(0.051));
  EXPECT_EQ(mended.expectation, Expectation::Known);
  EXPECT_EQ(
      mended.expected,
      "known; better than configuration.json:7 accepts (R is 2 % brighter, was 5.1 % brighter): accept it anew");
  EXPECT_EQ(marked(off_by(0.05, 0.002), fails_by_light(0.051)).expected, "known");
}

TEST(ExpectedVerdicts, AnEntryThatHasExpiredCountsNoMoreAndIsNamed) {
  auto entry = fails_by_psnr();
  entry.until = registry::Day{"2026-11-24"};
  EXPECT_EQ(marked(failed(30, false), entry, "2026-11-24").expectation, Expectation::Known);
  const auto later = marked(failed(30, false), entry, "2026-11-25");
  EXPECT_EQ(later.expectation, Expectation::News);
  EXPECT_EQ(later.expected, "configuration.json:7 accepted it until 2026-11-24 and has expired (known)");
  auto passed = failed(90, true);
  passed.verdict = Verdict::Pass;
  EXPECT_EQ(marked(passed, entry, "2026-11-25").expectation, Expectation::None);
}

TEST(ExpectedVerdicts, FailuresAreAcceptedForTheirSuiteAndSizeAndBetterOnesAnew) {
  results::RunRecord run;
  run.suite = "suite";
  run.size = "1/4";
  run.started = "2026-11-25T10:00:00";
  run.targets = {off_by(-0.02, 0.002)};
  const auto accepted = run::accepted_failures(run, {}, "why");
  ASSERT_EQ(accepted.size(), 1U);
  EXPECT_EQ(accepted[0].suite, "suite");
  EXPECT_EQ(accepted[0].size, registry::QuarterSize);
  EXPECT_EQ(accepted[0].measure.at("mean_ratio_r"), -0.02);
  EXPECT_EQ(accepted[0].reason, "why");
  const std::vector present{fails_by_light(-0.051)};
  run::mark_expected(present, run);
  ASSERT_EQ(run.targets[0].expectation, Expectation::Known);
  const auto anew = run::accepted_failures(run, present, "why");
  ASSERT_EQ(anew.size(), 1U);
  EXPECT_EQ(anew[0].measure.at("mean_ratio_r"), -0.02);
  EXPECT_EQ(anew[0].reason, "known");
  run::mark_expected(accepted, run);
  EXPECT_TRUE(run::accepted_failures(run, accepted, "why").empty());
}

TEST(ExpectedVerdicts, AcceptedFailuresAreOfTheVersionThatFailed) {
  results::RunRecord run;
  run.suite = "suite";
  run.size = "1/4";
  run.started = "2026-11-25T10:00:00";
  run.targets = {off_by(-0.02, 0.002)};
  results::RendererRecord renderer;
  renderer.name = run.targets[0].renderer;
  renderer.version = "Blender 4.3.2";
  run.renderers = {renderer};
  const auto accepted = run::accepted_failures(run, {}, "why");
  ASSERT_EQ(accepted.size(), 1U);
  EXPECT_EQ(accepted[0].version.text, "=4.3.2");
  run.targets[0].verdict = Verdict::Pass;
  run::mark_expected({fails_by_light(-0.02)}, run);
  EXPECT_NE(
      run.targets[0].expected.find(
          ": add \"version\" of those that fail if Blender 4.3.2 is not one of them, else remove the entry"),
      std::string::npos)
      << run.targets[0].expected;
}

// A strict run accepts no remarks but those that its configuration expects.
TEST(StrictRuns, RemarksAreNews) {
  const auto marked = [](bool is_strict, const std::string& expected) {
    std::vector<results::TargetRecord> targets(1);
    targets[0].renderer = "r";
    targets[0].target = "a";
    targets[0].declared = true;
    targets[0].verdict = results::Verdict::PassWithRemarks;
    std::vector<registry::ExpectedFailure> entries;
    if (!expected.empty())
      entries.push_back(
          {.place = "c:1", .renderer = "r", .scene = "a", .verdict = expected, .reason = "why"});
    run::mark_expected(entries, {"suite", kSize, "2026-01-01", is_strict}, {{"r", "1"}}, targets);
    return results::counts_as_failure(targets[0].verdict, targets[0].expectation);
  };
  EXPECT_FALSE(marked(false, ""));
  EXPECT_TRUE(marked(true, ""));
  EXPECT_FALSE(marked(true, "pass with remarks"));
  // An expected failure that passes is news, with remarks or without.
  EXPECT_TRUE(marked(false, "fail"));
}
