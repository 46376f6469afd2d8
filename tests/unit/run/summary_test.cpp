#include "run/summary.h"

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
