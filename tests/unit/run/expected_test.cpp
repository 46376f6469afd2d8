// Known failures against the verdicts of a run.
#include "run/expected.h"

#include <limits>

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

Expectation expectation_of(const results::TargetRecord& target, const registry::ExpectedFailure& entry) {
  std::vector<results::TargetRecord> targets{target};
  run::mark_expected({entry}, {{"r", "1"}}, targets);
  return targets.front().expectation;
}

}  // namespace

TEST(ExpectedVerdicts, AFailureLikeTheRecordedOneIsKnown) {
  EXPECT_EQ(expectation_of(failed(30, false), fails_by_psnr()), Expectation::Known);
  EXPECT_EQ(expectation_of(failed(20, false), fails_by_psnr()), Expectation::News);
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
