// Runs that end early, render again what failed, or are repeated; what they print; what they learn of times.
#include "base/text.h"
#include "cli/sandbox.h"

#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::cli_tests;

TEST(MaxFail, EndsTheRunAfterSoManyFailures) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "dark", "--maxfail", "1", "-o", "out"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_TRUE(contains(answer.text, "ended after 1 failed target (--maxfail)")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "skipped")) << answer.text;
  EXPECT_TRUE(
      contains(answer.text, "next: " + shell_text({ORBS_BINARY_DIR "/orbs", "run", "--resume", "out"})))
      << answer.text;
  // Without the option it goes on to the end.
  const auto rest = sandbox.orbs({"run", "--resume", "out"});
  EXPECT_EQ(rest.status, 1) << rest.text;
  EXPECT_FALSE(contains(rest.text, "skipped")) << rest.text;
  const auto few = sandbox.orbs({"run", "-r", "dark", "--maxfail", "50", "-o", "other"});
  EXPECT_FALSE(contains(few.text, "--maxfail")) << few.text;
}

TEST(LastFailed, RendersWhatFailedInTheNewestRunAgain) {
  const Sandbox sandbox;
  const auto none = sandbox.orbs({"run", "--last-failed", "-r", "good"});
  EXPECT_EQ(none.status, 2) << none.text;
  EXPECT_TRUE(contains(none.text, "--last-failed: there is no run of suite t")) << none.text;
  ASSERT_EQ(sandbox.orbs({"run", "-r", "good,dark", "-s", "grey,v1.5", "-o", "first"}).status, 1);
  const auto again = sandbox.orbs({"run", "--last-failed", "-o", "second"});
  EXPECT_EQ(again.status, 1) << again.text;
  const auto results = sandbox.read("second/results.json");
  EXPECT_TRUE(contains(results, "\"dark\"")) << again.text;
  EXPECT_TRUE(contains(again.text, "[1/2] dark")) << again.text;
  EXPECT_FALSE(contains(again.text, "] good")) << again.text;
  // Also after a resume.
  EXPECT_FALSE(contains(sandbox.orbs({"run", "--resume", "second"}).text, "] good"));
  ASSERT_EQ(sandbox.orbs({"run", "-r", "good", "-s", "grey", "-o", "third"}).status, 0);
  const auto nothing = sandbox.orbs({"run", "--last-failed", "-r", "good", "-o", "fourth"});
  EXPECT_EQ(nothing.status, 0) << nothing.text;
  EXPECT_TRUE(contains(nothing.text, "nothing to render: nothing failed in ")) << nothing.text;
  EXPECT_FALSE(sandbox.has("fourth"));
}

TEST(Durations, NameTheSlowestRenders) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "good", "--durations", "2"});
  EXPECT_TRUE(contains(answer.text, "slowest renders")) << answer.text;
  const auto table = answer.text.substr(answer.text.find("slowest renders"));
  std::size_t rows = 0;
  for (const auto& line : split(table, '\n'))
    if (line.starts_with("good ")) ++rows;
  EXPECT_EQ(rows, 2U) << table;
}

TEST(Repeat, OtherSeedsNameTheFlakyTargets) {
  const Sandbox sandbox;
  // Right with odd seeds only.
  sandbox.write(
      "flaky.sh",
      "#!/bin/sh\ngrey=0.5\n[ $(($3 / 16 % 2)) = 0 ] || grey=0.2\nexec " ORBS_BINARY_WORD
      "/orbs-fake-renderer --mode good --output \"$1\" --scene \"$2\" --width 12 --height 8 --grey $grey --spp 8 --seed \"$3\"\n");
  std::filesystem::permissions(sandbox.folder() / "flaky.sh", std::filesystem::perms::owner_all);
  replace_in(sandbox, "configuration.json", "\"renderers\": [",
             R"("renderers": [{"name": "flaky", "executable": "{root}/flaky.sh", "declares": "G5/M8",
 "command": ["{executable}", "{output}", "{scene}", "{seed}"]}, )");
  const auto answer =
      sandbox.orbs({"run", "-r", "flaky,good", "-s", "grey", "-c", "m1*", "--repeat", "3", "-o", "out"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  for (const char* folder : {"out/seed-1", "out/seed-17", "out/seed-33"})
    EXPECT_TRUE(sandbox.has(fmt::format("{}/results.json", folder))) << folder;
  EXPECT_TRUE(contains(answer.text, "flaky  flaky  M1  grey  1 fail, 2 pass")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "3 runs: 1 flaky target; the same in all: 1 pass")) << answer.text;
  // One summary, and no table for each.
  EXPECT_FALSE(contains(answer.text, "requirement")) << answer.text;
}

TEST(Loudness, QuietPrintsFailuresAndVerboseWholeReasons) {
  const Sandbox sandbox;
  const auto quiet = sandbox.orbs({"run", "-q", "-r", "good,dark", "-s", "grey", "-c", "m1*", "-o", "quiet"});
  EXPECT_EQ(quiet.status, 1);
  EXPECT_FALSE(contains(quiet.text, "] good")) << quiet.text;
  EXPECT_TRUE(contains(quiet.text, "] dark")) << quiet.text;
  EXPECT_FALSE(contains(quiet.text, "configuration:")) << quiet.text;
  EXPECT_TRUE(contains(quiet.text, "good: 1 pass\ndark: 1 fail\nresults: ")) << quiet.text;
  const auto usual = sandbox.orbs({"run", "-r", "dark", "-s", "grey", "-c", "m1*", "-o", "usual"});
  const auto verbose = sandbox.orbs({"run", "-v", "-r", "dark", "-s", "grey", "-c", "m1*", "-o", "verbose"});
  EXPECT_GT(verbose.text.size(), usual.text.size());
  EXPECT_TRUE(contains(usual.text, " ...")) << usual.text;
}

TEST(Label, NamesTheRunInTheHistory) {
  const Sandbox sandbox;
  EXPECT_EQ(sandbox.orbs({"run", "-r", "dark", "-s", "grey", "--label", "ab12cd", "-o", "out"}).status, 1);
  EXPECT_TRUE(contains(sandbox.read("out/results.json"), "\"label\": \"ab12cd\""));
  // It stays with the run.
  EXPECT_EQ(sandbox.orbs({"run", "--resume", "out"}).status, 1);
  EXPECT_TRUE(contains(sandbox.read("out/results.json"), "\"label\": \"ab12cd\""));
  EXPECT_EQ(sandbox.orbs({"history", "out", "-o", "page.html"}).status, 0);
  EXPECT_TRUE(contains(sandbox.read("page.html"), "ab12cd"));
}

TEST(Label, StaysWithAPlanAndWithItsMergedShards) {
  const Sandbox sandbox;
  ASSERT_EQ(
      sandbox.orbs({"run", "-r", "good", "-c", "m1*", "--label", "ab12cd", "--shard", "1/2", "-o", "one"})
          .status,
      0);
  const auto two = sandbox.orbs({"run", "--plan", "one/plan.json", "--shard", "2/2", "-o", "two"});
  ASSERT_EQ(two.status, 0) << two.text;
  const auto merged = sandbox.orbs({"merge", "one", "two", "-o", "whole"});
  ASSERT_EQ(merged.status, 0) << merged.text;
  for (const char* folder : {"two", "whole"})
    EXPECT_TRUE(contains(sandbox.read(std::string(folder) + "/results.json"), "\"label\": \"ab12cd\""))
        << folder;
  EXPECT_EQ(sandbox.orbs({"run", "--last-failed", "--shard", "1/2"}).status, 2);
}

TEST(Estimates, AreLearnedFromRunsOfAnyNameAndSize) {
  const Sandbox sandbox;
  ASSERT_EQ(sandbox.orbs({"run", "-r", "good", "-s", "grey", "-c", "m1*", "-o", "mine"}).status, 0);
  const auto named = sandbox.orbs({"run", "-r", "good", "-s", "grey", "-c", "m1*", "-o", "again"});
  EXPECT_TRUE(contains(named.text, "1 render, about 1 s\n")) << named.text;
  const auto sized =
      sandbox.orbs({"run", "-r", "good", "-s", "grey", "-c", "m1*", "--size", "1/2", "-o", "small"});
  EXPECT_TRUE(contains(sized.text, "1 render, about 1 s, roughly: by other sizes or scenes\n")) << sized.text;
}

TEST(Estimates, OfACompleteRunNothingIsLeft) {
  const Sandbox sandbox;
  ASSERT_EQ(sandbox.orbs({"run", "-r", "good", "-s", "grey", "-c", "m1*", "-o", "out"}).status, 0);
  const auto answer = sandbox.orbs({"run", "--resume", "out"});
  EXPECT_TRUE(contains(answer.text, "1 render, all finished: nothing is left to render\n")) << answer.text;
}

TEST(Estimates, ComeWithTheProgramForEverySuiteSizeAndRenderer) {
  const Sandbox sandbox;
  for (const char* suite : {"orbs", "appearance", "gi"}) {
    const auto answer = sandbox.shell(fmt::format(
        "{}/orbs run --dry-run --configuration {}/configuration.json --suite {} -r orbs 2>&1 | grep renders",
        ORBS_BINARY_WORD, ORBS_SOURCE_WORD, suite));
    EXPECT_TRUE(contains(answer.text, " renders, about ")) << suite << "\n" << answer.text;
    EXPECT_FALSE(contains(answer.text, "no recorded time")) << suite << "\n" << answer.text;
  }
}
