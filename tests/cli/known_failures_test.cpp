// Failures that configuration.json expects: named, green, and red when they are news.
#include "cli/sandbox.h"

#include <gtest/gtest.h>

using orbs::cli_tests::configuration_with;
using orbs::cli_tests::contains;
using orbs::cli_tests::replace_in;
using orbs::cli_tests::Sandbox;

namespace {

// The image of "dark" is 0.2 in place of 0.5, which is a psnr_srgb8 of 12.01 dB.
void expect_failure(const Sandbox& sandbox, const std::string& entry) {
  auto text = configuration_with("");
  sandbox.write("configuration.json", text.insert(text.rfind('}'), ", \"expected\": [" + entry + "]"));
}

const std::string kDark =
    R"({"renderer": "dark", "scene": "grey", "verdict": "fail", "reason": "it was built so")";

}  // namespace

TEST(KnownFailures, AreNamedAndDoNotMakeTheRunFail) {
  const Sandbox sandbox;
  expect_failure(sandbox, kDark + "}");
  const auto answer = sandbox.orbs({"run", "-v", "-r", "dark", "-c", "m1_grey", "-s", "grey", "-o", "out"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "12.01 known")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "it was built so; R is 60 % darker (60 to 60 %)")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "1 known")) << answer.text;
  const auto junit = sandbox.read("out/junit.xml");
  EXPECT_TRUE(contains(junit, "failures=\"0\"")) << junit;
  EXPECT_TRUE(contains(junit, "<skipped type=\"known\" message=\"known: it was built so; ")) << junit;
  EXPECT_TRUE(contains(sandbox.read("out/results.csv"),
                       ",fail,known,it was built so,\"R is 60 % darker (60 to 60 %), "));
  EXPECT_TRUE(contains(sandbox.read("out/results.json"), "\"exit_status\": 0"));
}

TEST(KnownFailures, AreBoundToTheVersionOfTheirRenderer) {
  const Sandbox sandbox;
  expect_failure(sandbox, kDark + R"(, "version": "<4.0"})");
  // "dark" says no version, so it lies in no range.
  EXPECT_EQ(sandbox.orbs({"run", "-r", "dark", "-c", "m1_grey", "-s", "grey"}).status, 1);
}

TEST(KnownFailures, APassIsNews) {
  const Sandbox sandbox;
  expect_failure(sandbox,
                 R"({"renderer": "g*d", "scene": "grey", "verdict": "fail", "reason": "old fault"})");
  const auto answer = sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-s", "grey", "-o", "out"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_TRUE(contains(answer.text, "inf unexpected pass")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "expects 'fail' (old fault): add \"version\" of those that fail"))
      << answer.text;
  EXPECT_TRUE(contains(sandbox.read("out/junit.xml"),
                       "<failure type=\"unexpected pass\" message=\"unexpected pass: "));
}

TEST(KnownFailures, AnotherVerdictIsNews) {
  const Sandbox sandbox;
  expect_failure(sandbox,
                 R"({"renderer": "segfault", "scene": "grey", "verdict": "timeout", "reason": "slow"})");
  const auto answer = sandbox.orbs({"run", "-r", "segfault", "-c", "m1_grey", "-s", "grey"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_TRUE(contains(answer.text, "expects 'timeout'; ")) << answer.text;
}

TEST(KnownFailures, OneThatGetsWorseIsNewsAndALittleWorseIsNot) {
  const Sandbox sandbox;
  const auto status = [&](const std::string& measure) {
    expect_failure(sandbox, kDark + R"(, "measure": {)" + measure + "}}");
    return sandbox.orbs({"run", "-r", "dark", "-c", "m1_grey", "-s", "grey"});
  };
  // All checks of its case fail but for the two on numbers that a constant image does not have.
  expect_failure(sandbox, kDark + "}");
  const std::string others =
      R"(, "mean_ratio_r": -0.6, "mean_ratio_g": -0.6, "mean_ratio_b": -0.6, "local_bias": 0.6, "edge_blur": null,
      "window_error_8px": 0.6, "window_error_16px": 0.6, "pattern_error": 100)";
  const auto same = status(R"("psnr_srgb8": 12.1)" + others);
  EXPECT_EQ(same.status, 0) << same.text;
  const auto worse = status(R"("psnr_srgb8": 13.0)" + others);
  EXPECT_EQ(worse.status, 1);
  EXPECT_TRUE(contains(worse.text, "the PSNR is 12.01 dB, which is worse than 13 dB, the failure that "))
      << worse.text;
  const auto other = status(R"("ssim": 0.5)");
  EXPECT_EQ(other.status, 1);
  EXPECT_TRUE(contains(other.text, "it fails by psnr_srgb8, which is not among the failed checks of "))
      << other.text;
}

TEST(KnownFailures, UnknownScenesAndVerdictsAreRefusedWithTheirPlace) {
  const Sandbox sandbox;
  expect_failure(sandbox, R"({"renderer": "dark", "scene": "gray", "verdict": "fail", "reason": "r"})");
  const auto scene = sandbox.orbs({"run", "-r", "dark"});
  EXPECT_EQ(scene.status, 2);
  EXPECT_TRUE(contains(scene.text, "no scene of any suite matches 'gray' (did you mean 'grey'?)"))
      << scene.text;
  EXPECT_TRUE(contains(scene.text, "configuration.json:")) << scene.text;
  expect_failure(sandbox,
                 R"({"renderer": "dark", "scene": "grey", "verdict": "missing reference", "reason": "r"})");
  const auto verdict = sandbox.orbs({"run", "-r", "dark"});
  EXPECT_EQ(verdict.status, 2);
  EXPECT_TRUE(contains(verdict.text, "no failure has the verdict 'missing reference'")) << verdict.text;
}

TEST(KnownFailures, AreWrittenByAcceptFailuresAndHoldInTheNextRun) {
  const Sandbox sandbox;
  const auto before = sandbox.read("configuration.json");
  const auto accepted = sandbox.orbs({"run", "-r", "dark,good,segfault", "-c", "m1_grey", "-s", "grey", "-o",
                                      "out", "--accept-failures", "the light is wrong"});
  EXPECT_EQ(accepted.status, 0) << accepted.text;
  EXPECT_TRUE(contains(accepted.text, "2 known failures written to ")) << accepted.text;
  const auto after = sandbox.read("configuration.json");
  const auto same = before.rfind(']') + 1;
  EXPECT_EQ(after.substr(0, same), before.substr(0, same));
  EXPECT_TRUE(contains(after, "\"suite\": \"t\"") && contains(after, "\"size\": \"1\"")) << after;
  EXPECT_TRUE(contains(after, "\"mean_ratio_r\": -0.59999")) << after;
  EXPECT_TRUE(contains(sandbox.read("out/results.json"), "\"expectation\": \"known\""));
  EXPECT_TRUE(contains(sandbox.read("out/results.csv"), ",known,the light is wrong,"));
  const auto again = sandbox.orbs({"run", "-r", "dark,good,segfault", "-c", "m1_grey", "-s", "grey"});
  EXPECT_EQ(again.status, 0) << again.text;
  // The accepted numbers count: a darker image is worse than the one that is known.
  replace_in(sandbox, "configuration.json", "--grey\", \"0.2\"", "--grey\", \"0.05\"");
  const auto worse = sandbox.orbs({"run", "-r", "dark", "-c", "m1_grey", "-s", "grey"});
  EXPECT_EQ(worse.status, 1) << worse.text;
  EXPECT_TRUE(contains(worse.text, ", which is worse than ")) << worse.text;
}

TEST(KnownFailures, OneThatHasExpiredIsRedAndNamed) {
  const Sandbox sandbox;
  expect_failure(sandbox, kDark + R"(, "until": "2020-01-31"})");
  const auto answer = sandbox.orbs({"run", "-r", "dark", "-c", "m1_grey", "-s", "grey", "-o", "out"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_TRUE(contains(answer.text, " accepted it until 2020-01-31 and has expired (it was built so)"))
      << answer.text;
}

// The plan of a run holds the entries, too, and is read again.
TEST(KnownFailures, AreReadBackFromThePlanOfARun) {
  const Sandbox sandbox;
  expect_failure(sandbox, kDark + R"(, "suite": "t", "size": "1", "until": "2999-12-31"})");
  EXPECT_EQ(sandbox.orbs({"run", "-r", "dark", "-c", "m1_grey", "-s", "grey", "-o", "out"}).status, 0);
  EXPECT_EQ(sandbox.orbs({"run", "--plan", "out/plan.json", "-o", "again"}).status, 0);
}

TEST(KnownFailures, AResumedRunIsComparedWithTheEntriesOfToday) {
  const Sandbox sandbox;
  EXPECT_EQ(sandbox.orbs({"run", "-r", "dark", "-c", "m1_grey", "-s", "grey", "-o", "out"}).status, 1);
  expect_failure(sandbox, kDark + "}");
  EXPECT_EQ(sandbox.orbs({"run", "--resume", "out"}).status, 0);
}
