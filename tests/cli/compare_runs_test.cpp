// orbs compare-runs on real runs of the fake renderer.
#include "cli/sandbox.h"

#include <gtest/gtest.h>

using orbs::cli_tests::contains;
using orbs::cli_tests::replace_in;
using orbs::cli_tests::Sandbox;

TEST(CompareRunsCommand, ARunEqualToItselfHasStatusZero) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "good", "-o", "one"});
  const auto answer = sandbox.orbs({"compare-runs", "one", "one"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "one against one: 0 worse, 0 better, 0 changed otherwise"))
      << answer.text;
}

TEST(CompareRunsCommand, AVerdictThatGotWorseHasStatusOneAndAReason) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "good", "-s", "grey", "-o", "one"});
  replace_in(sandbox, "configuration.json", "--grey\", \"0.5\"", "--grey\", \"0.2\"");
  sandbox.orbs({"run", "-r", "good", "-s", "grey", "-o", "two"});
  const auto answer = sandbox.orbs({"compare-runs", "one", "two", "--markdown"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_TRUE(contains(answer.text, "| worse | good | M1 | grey | verdict | pass | fail |")) << answer.text;
  const auto back = sandbox.orbs({"compare-runs", "two", "one", "--json"});
  EXPECT_EQ(back.status, 0) << back.text;
  EXPECT_TRUE(contains(back.text, "\"direction\": \"better\"")) << back.text;
}

TEST(CompareRunsCommand, WhatIsNoRunHasStatusTwo) {
  const Sandbox sandbox;
  EXPECT_EQ(sandbox.orbs({"compare-runs", "cases", "references"}).status, 2);
}
