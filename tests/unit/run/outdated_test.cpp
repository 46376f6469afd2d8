#include "run/outdated.h"

#include <gtest/gtest.h>

using namespace orbs;

namespace {

std::string hash_of(const std::vector<std::string>& command, int spp) {
  run::Plan plan;
  plan.scenes.push_back({"s", "s.json", spp, std::make_shared<const scene::Scene>()});
  registry::Renderer entry;
  entry.name = "r";
  entry.scene_format = "povray";
  entry.command = command;
  plan.renderers.push_back({entry, "/usr/bin/r"});
  run::PlannedJob job;
  job.spp = spp;
  return run::settings_hash(plan, job);
}

}  // namespace

// What an exporter makes of a placeholder is a setting, too: an image with another depth is another image.
TEST(Outdated, SettingsAreTheWordsThatTheJobGets) {
  const std::vector<std::string> command{"{executable}", "{scene}", "{output}", "+R{aa_grid}"};
  EXPECT_NE(hash_of(command, 256), hash_of(command, 257));
  EXPECT_EQ(hash_of(command, 200), hash_of(command, 256));
  EXPECT_NE(hash_of(command, 256), hash_of({"{executable}", "{scene}", "{output}", "+R5"}, 256));
}
