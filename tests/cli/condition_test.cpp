// What rounding decides in a scene is measured and judged by a run, where its case has a bound and its
// renderer can work in double precision.
#include "cli/sandbox.h"
#include "results/record.h"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::Answer;
using cli_tests::contains;
using cli_tests::replace_in;
using cli_tests::Sandbox;

namespace {

// "good", whose image is 0.5 all over, and in double precision what `more` makes of it; the case allows 1 %.
class ConditionSandbox : public Sandbox {
 public:
  explicit ConditionSandbox(const std::string& more) {
    replace_in(*this, "cases/m1_grey/case.json", "\"scenes\"",
               R"("condition_map": {"max": 0.01, "reason": "r"}, "scenes")");
    if (!more.empty()) add_to_good(fmt::format(R"(, "double_precision": [{}])", more));
  }
  Answer run() const { return orbs({"run", "-v", "-r", "good", "-s", "grey", "-c", "m1*", "-o", "out"}); }
  results::JobFile job() const {
    return results::read_job_file(folder() / "out" / "good" / "grey" / "job.json");
  }
};

const results::Check* check_of(const results::JobFile& file) {
  for (const auto& check : file.targets.at(0).checks)
    if (check.what == "condition_map") return &check;
  return nullptr;
}

}  // namespace

TEST(Condition, WithinItsBoundIsACheckThatPasses) {
  const ConditionSandbox sandbox(R"("--grey", "0.504")");
  const auto answer = sandbox.run();
  EXPECT_EQ(answer.status, 0) << answer.text;
  const auto file = sandbox.job();
  const auto* check = check_of(file);
  ASSERT_NE(check, nullptr);
  EXPECT_TRUE(check->passed) << check->reason;
  EXPECT_EQ(check->max, 0.01);
  EXPECT_NEAR(file.job.condition.pixels, 0.008, 1e-6);
  EXPECT_EQ(file.job.condition.spp, 8) << "no more than those of the case";
  EXPECT_GT(file.job.condition.cpu_seconds, 0);
  EXPECT_LT(file.job.condition.cpu_seconds, file.job.cost.cpu_seconds);
  EXPECT_TRUE(contains(file.job.condition.shell, "double-precision.exr")) << file.job.condition.shell;
  EXPECT_TRUE(contains(file.job.condition.shell, "--grey 0.504")) << file.job.condition.shell;
  for (const char* image : {"single-precision.exr", "double-precision.exr", "result.exr"})
    EXPECT_TRUE(sandbox.has(fmt::format("out/good/grey/{}", image))) << image;
}

TEST(Condition, BeyondItsBoundFailsARunWhoseImageIsRight) {
  const ConditionSandbox sandbox(R"("--grey", "0.51")");
  const auto answer = sandbox.run();
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_TRUE(contains(answer.text,
                       "in double precision single pixels differ by 2 % on average, at most 1 % is "
                       "allowed: rounding decides what they show"))
      << answer.text;
  EXPECT_EQ(sandbox.job().targets.at(0).verdict, results::Verdict::Fail);
}

TEST(Condition, IsAskedOnlyOfRenderersThatCanAnswer) {
  const ConditionSandbox sandbox("");
  EXPECT_EQ(sandbox.run().status, 0);
  EXPECT_EQ(check_of(sandbox.job()), nullptr);
  EXPECT_EQ(sandbox.job().job.condition.spp, 0);
  EXPECT_FALSE(sandbox.has("out/good/grey/double-precision.exr"));
}

TEST(Condition, ThatIsNotKnownIsNoPass) {
  const ConditionSandbox sandbox(R"("--mode", "exit3")");
  const auto answer = sandbox.run();
  EXPECT_EQ(answer.status, 1) << answer.text;
  const auto target = sandbox.job().targets.at(0);
  EXPECT_EQ(target.verdict, results::Verdict::Inconclusive);
  EXPECT_TRUE(contains(target.reason, "what rounding decides is not known: the render in double precision"))
      << target.reason;
  EXPECT_TRUE(contains(target.reason, "cannot find the sun")) << target.reason;
}

// The looks of a render share the one answer, and a resumed run takes it over, also for another bound.
TEST(Condition, IsAskedOnceAndKept) {
  const ConditionSandbox sandbox(R"("--grey", "0.504")");
  replace_in(sandbox, "configuration.json", "\"fixed_samples\": true", "\"fixed_samples\": false");
  replace_in(sandbox, "configuration.json", R"("--mode", "good")", R"("--mode", "noisy")");
  EXPECT_EQ(sandbox.run().status, 0);
  const auto file = sandbox.job();
  EXPECT_GE(file.job.sampling.looks, 2);
  EXPECT_EQ(file.job.condition.spp, 8);
  EXPECT_NEAR(file.job.condition.pixels, 0.008, 2e-4) << "0.004 over the mean of a noisy image";
  EXPECT_TRUE(sandbox.has("out/good/grey/double-precision.exr"));
  replace_in(sandbox, "cases/m1_grey/case.json", R"("max": 0.01)", R"("max": 0.001)");
  const auto resumed = sandbox.orbs({"run", "-v", "--resume", "out"});
  EXPECT_EQ(resumed.status, 1) << resumed.text;
  EXPECT_EQ(sandbox.job().targets.at(0).verdict, results::Verdict::Fail);
  EXPECT_EQ(sandbox.job().job.condition.cpu_seconds, file.job.condition.cpu_seconds);
  EXPECT_TRUE(sandbox.has("out/good/grey/double-precision.exr"));
}

TEST(Condition, OfAnotherArithmeticIsAskedAgain) {
  const ConditionSandbox sandbox(R"("--grey", "0.504")");
  EXPECT_EQ(sandbox.run().status, 0);
  replace_in(sandbox, "configuration.json", "0.504", "0.51");
  EXPECT_EQ(sandbox.orbs({"run", "--resume", "out"}).status, 1);
  EXPECT_NEAR(sandbox.job().job.condition.pixels, 0.02, 1e-6);
}
