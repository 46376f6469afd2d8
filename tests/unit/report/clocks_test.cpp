#include "report/clocks.h"

#include "report/report_card.h"

#include <gtest/gtest.h>

using namespace orbs;

namespace {

results::RunRecord run_with(double wall_s, double cpu_s, std::optional<double> stated_s) {
  results::RunRecord run;
  results::JobRecord job;
  job.identity.renderer = "r";
  job.cost.started = "2026-11-25T10:00:00";
  job.cost.wall_seconds = wall_s;
  job.cost.cpu_seconds = cpu_s;
  job.cost.render_seconds = stated_s;
  run.jobs = {job};
  return run;
}

}  // namespace

// A renderer that slept and stated 0.0001 s stood on its card with 0.0018 s, and no word.
TEST(Clocks, ThatContradictEachOtherAreSaid) {
  const auto text = report::clocks_text(run_with(18, 0.1, 0.0018), "r");
  EXPECT_NE(text.find("its processes ran for 18 s and used 0.1 s of CPU"), std::string::npos) << text;
  EXPECT_NE(text.find("it states 0.0018 s of rendering where its processes ran for 18 s"), std::string::npos)
      << text;
  EXPECT_TRUE(report::renders_elsewhere(run_with(18, 0.1, {}), "r"));
  EXPECT_NE(report::clocks_text(run_with(10, 20, 15), "r"), "") << "more than it took";
}

TEST(Clocks, ThatAgreeAreNotSaid) {
  EXPECT_EQ(report::clocks_text(run_with(10, 19, 9), "r"), "");
  EXPECT_EQ(report::clocks_text(run_with(10, 19, {}), "r"), "");
  EXPECT_EQ(report::clocks_text(run_with(10, 4, 2), "r"), "") << "a start of some seconds";
  EXPECT_EQ(report::clocks_text(run_with(0.5, 0.001, 0.0001), "r"), "") << "too short to tell";
  EXPECT_EQ(report::clocks_text(run_with(18, 0.1, 0.0018), "other"), "");
}
