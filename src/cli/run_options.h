#pragma once

#include "command_line/command.h"
#include "registry/run_settings.h"

#include <string>
#include <vector>

namespace orbs::cli {

/// The options of orbs run; the configuration sets those that are not given.
struct RunOptions {
  std::string suite;
  std::vector<std::string> cases, scenes, requirements, renderers;
  std::string executable;
  std::string output;
  std::string resume;
  std::string shard;
  int jobs = 1;
  int threads = 0;
  int seed = 1;
  double spp_scale = 1;
  std::string size;
  std::string accept_failures;
  bool log = true;
  bool sandbox = false;
  bool dry_run = false;
  bool view = false;
};

/// Adds the options that say what is rendered and how, which `orbs submit` has, too. `options` must live as
/// long as the command.
void add_choice_options(const command_line::Command& command, RunOptions& options);

/// Adds all options of orbs run.
void add_run_options(const command_line::Command& command, RunOptions& options);

/// `settings` with the options that were given in place of its own. InputError for -e without a program.
registry::RunSettings run_settings(const command_line::Command& command,
                                   const RunOptions& options,
                                   registry::RunSettings settings);

}  // namespace orbs::cli
