// A renderer that is not shut off from the references could have made its image from them.
#include "run/summary.h"

#include <gtest/gtest.h>

using namespace orbs;

namespace {

bool could_read(const run::Plan& plan) {
  results::RunRecord record;
  run::summarise(plan, {"1"}, record);
  return record.renderers.at(0).could_read_references;
}

}  // namespace

TEST(References, OnlyASandboxHidesThemFromAStrangersRenderer) {
  run::Plan plan;
  auto& renderer = plan.renderers.emplace_back();
  renderer.entry.name = "stranger";
  renderer.executable = "/bin/sh";
  EXPECT_TRUE(could_read(plan));
  plan.settings.sandbox = true;
  EXPECT_FALSE(could_read(plan));
}
