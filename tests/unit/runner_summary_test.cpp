#include "runner/execute.h"
#include "runner/summary.h"

#include <gtest/gtest.h>

using namespace orbs;
using results::Verdict;

namespace {

results::RequirementRecord requirement(const std::string& code, Verdict verdict) {
  return {code, "", {{"r", {true, verdict, std::nullopt, ""}}}};
}

}  // namespace

TEST(Measured, FeaturesAreThePassesOfTheGroupsThatWereTested) {
  EXPECT_EQ(runner::measured_features({requirement("G1", Verdict::Pass), requirement("G2", Verdict::Pass),
                                       requirement("M1", Verdict::Pass), requirement("M2", Verdict::Fail),
                                       requirement("M3", Verdict::Pass), requirement("M4", Verdict::Pass),
                                       requirement("L1", Verdict::Unsupported)},
                                      "r"),
            "G2/M4-(2)/L0");
  EXPECT_EQ(runner::measured_features({requirement("G1", Verdict::Inconclusive)}, "r"), "G0");
}

TEST(RenderSeconds, AreTheNumberBehindTheLastLineWithThePrefix) {
  EXPECT_EQ(runner::seconds_in("a\nt: 1.5\nt: 2.25 s\nx t: 9\n", "t: "), 2.25);
  EXPECT_EQ(runner::seconds_in("t: soon\n", "t: "), std::nullopt);
  EXPECT_EQ(runner::seconds_in("", "t: "), std::nullopt);
}
