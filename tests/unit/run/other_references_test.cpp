// What the diagnosis compares an image with, whatever the filters of its run.
#include "run/other_references.h"

#include "registry/cases.h"

#include <gtest/gtest.h>

using namespace orbs;

TEST(OtherReferences, AreThoseOfTheWholeCaseThoughTheRunHasOneTarget) {
  const std::filesystem::path data = ORBS_SOURCE_DIR "/data";
  run::Plan plan;
  plan.suite.data = {data};
  plan.suite.references = data / "references/orbs";
  plan.settings.size_divisor = registry::EighthSize;
  const auto whole = registry::load_case(data / "cases/orbs/a1_trace_depth/case.json");
  const auto chosen = registry::with_targets(whole, {"101-depth2"});
  ASSERT_EQ(registry::target_names(chosen).size(), 1U);
  const auto others = run::other_references(plan, chosen, "101-depth2", {});
  EXPECT_EQ(others.size(), registry::target_names(whole).size() - 1);
  ASSERT_TRUE(others.contains("101-depth1"));
  EXPECT_EQ(others.at("101-depth1").width, 64);
  EXPECT_FALSE(others.contains("101-depth2"));
  // A reference of a scene as it was before is none.
  plan.reference_hashes["101-depth1"] = "of another scene";
  EXPECT_FALSE(run::other_references(plan, chosen, "101-depth2", {}).contains("101-depth1"));
}
