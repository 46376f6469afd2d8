#include "run/summary.h"

#include <limits>

#include <gtest/gtest.h>

using namespace orbs;
using results::Verdict;

namespace {

results::RequirementRecord requirement(const std::string& code, Verdict verdict) {
  return {code, "", {{"r", {true, verdict, std::nullopt, ""}}}};
}

}  // namespace

TEST(Measured, FeaturesAreThePassesOfTheGroupsThatWereTested) {
  EXPECT_EQ(run::measured_features({requirement("G1", Verdict::Pass), requirement("G2", Verdict::Pass),
                                    requirement("M1", Verdict::Pass), requirement("M2", Verdict::Fail),
                                    requirement("M3", Verdict::Pass), requirement("M4", Verdict::Pass),
                                    requirement("L1", Verdict::Unsupported)},
                                   "r"),
            "G2/M4-(2)/L0");
}

TEST(Measured, WhatIsNotKnownIsNotShownAsNotMet) {
  for (const auto verdict : {Verdict::Inconclusive, Verdict::Skipped, Verdict::MissingReference})
    EXPECT_EQ(run::measured_features({requirement("G1", verdict)}, "r"), "G?");
  EXPECT_EQ(
      run::measured_features({requirement("G1", Verdict::Pass), requirement("G2", Verdict::Skipped),
                              requirement("G3", Verdict::Pass), requirement("G4", Verdict::Fail),
                              requirement("G5", Verdict::Inconclusive), requirement("M1", Verdict::Fail),
                              requirement("M2", Verdict::Inconclusive)},
                             "r"),
      "G3?(2,5)/M0?(2)");
  EXPECT_EQ(run::measured_features({requirement("G1", Verdict::Fail)}, "other"), "G?");
}

// Seven images of the built-in tracer passed at 30 dB, and their cells said 37.
TEST(LowestPsnr, IsThatOfTheImagesAndWhatDecidedStandsBesideIt) {
  const auto target_of = [](double own_db, double without_noise_db, Verdict verdict) {
    results::TargetRecord target;
    target.requirement = "A1";
    target.renderer = "r";
    target.verdict = verdict;
    const bool passes = verdict == Verdict::Pass;
    results::Check gate;
    gate.what = "psnr_srgb8";
    gate.min = 35;
    gate.passed = gate.decided = passes;
    target.checks = {gate};
    target.measures = {{"psnr_srgb8", own_db, "dB", ""},
                       {std::string(results::kPsnrWithoutNoise), without_noise_db, "dB", ""}};
    return target;
  };
  const auto cell_of = [](const std::vector<results::TargetRecord>& targets) {
    results::RunRecord record;
    record.cases.emplace_back();
    record.cases[0].requirement = "A1";
    record.targets = targets;
    run::summarise(record);
    return record.requirements.at(0).cells.at("r");
  };
  const auto passed = cell_of({target_of(38, 45, Verdict::Pass), target_of(30.5, 37.2, Verdict::Pass)});
  EXPECT_EQ(passed.lowest_psnr_db, 30.5);
  EXPECT_EQ(passed.lowest_psnr_without_noise_db, 37.2);
  const auto by_itself = cell_of({target_of(38, 45, Verdict::Pass)});
  EXPECT_EQ(by_itself.lowest_psnr_db, 38);
  EXPECT_EQ(by_itself.lowest_psnr_without_noise_db, std::nullopt);
  const double none_seen = std::numeric_limits<double>::infinity();
  const auto open = cell_of({target_of(27, none_seen, Verdict::Inconclusive)});
  EXPECT_EQ(open.lowest_psnr_db, 27) << "an open verdict with \"inf dB\" looked like a mistake";
  EXPECT_EQ(open.lowest_psnr_without_noise_db, std::nullopt);
  const auto without_error = cell_of({target_of(30, none_seen, Verdict::Pass)});
  EXPECT_EQ(without_error.lowest_psnr_without_noise_db, 99);
}

// Mitsuba's A1 was told as measured: one of its images passed unexpectedly, another was known to be
// undecided.
TEST(Measured, AnUnexpectedPassHidesNoKnownFailure) {
  results::RunRecord record;
  record.cases.emplace_back();
  record.cases[0].requirement = "A1";
  record.renderers.emplace_back();
  record.renderers[0].name = "r";
  for (const auto& [verdict, expectation] : {std::pair{Verdict::Inconclusive, results::Expectation::Known},
                                             std::pair{Verdict::Pass, results::Expectation::News}}) {
    auto& target = record.targets.emplace_back();
    target.requirement = "A1";
    target.renderer = "r";
    target.declared = true;
    target.verdict = verdict;
    target.expectation = expectation;
  }
  run::summarise(record);
  const auto& cell = record.requirements.at(0).cells.at("r");
  EXPECT_EQ(cell.verdict, Verdict::Pass) << "the exit status rests on it";
  EXPECT_EQ(cell.worst_verdict, Verdict::Inconclusive);
  EXPECT_EQ(record.renderers[0].measured, "A?");
}
