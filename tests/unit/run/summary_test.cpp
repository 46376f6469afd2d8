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
