// The options of the settings of a run: what is given replaces the configuration's defaults, and nothing else
// does.
#include "cli/run/run_options.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

// The settings after this command line. The command has a --spp-scale of its own where that is left out.
registry::RunSettings settings_after(std::vector<std::string> words,
                                     const std::set<std::string>& keys,
                                     const registry::RunSettings& defaults) {
  const command_line::Program program("orbs", "", "");
  const auto command = program.command();
  cli::RunOptions options;
  double own_scale = 0;
  cli::add_settings(command, options, keys);
  if (!keys.contains("spp_scale")) command.add_option("--spp-scale", own_scale, "Of something else");
  words.insert(words.begin(), "orbs");
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  const auto parsed = program.parse(static_cast<int>(argv.size()), argv.data());
  EXPECT_EQ(parsed.problem, "");
  return cli::run_settings(command, options, defaults);
}

}  // namespace

TEST(RunOptions, ReplaceTheDefaultsWhereTheyAreGiven) {
  registry::RunSettings defaults;
  defaults.threads = 7;
  defaults.sandbox = true;
  const auto settings = settings_after(
      {"-c", "a", "-c", "b,c", "-j", "3", "--spp-scale", "0.5", "--size", "1/4", "--no-log", "-e", "p"},
      cli::settings_but({}), defaults);
  EXPECT_EQ(settings.cases, "a,b,c");
  EXPECT_EQ(settings.jobs, 3);
  EXPECT_EQ(settings.spp_scale, 0.5);
  EXPECT_EQ(settings.size_divisor, registry::QuarterSize);
  EXPECT_FALSE(settings.log);
  EXPECT_EQ(settings.executable, "p");
  EXPECT_EQ(settings.scenes, "*");
  EXPECT_EQ(settings.threads, 7);
  EXPECT_TRUE(settings.sandbox);
}

TEST(RunOptions, LeaveAloneWhatAnOtherOptionOfTheSameNameMeans) {
  registry::RunSettings defaults;
  defaults.spp_scale = 2;
  EXPECT_EQ(settings_after({"--spp-scale", "5", "-s", "1"}, cli::kTargetSettings, defaults).spp_scale, 2);
}
