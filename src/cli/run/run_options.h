#pragma once

#include "command_line/command.h"
#include "registry/run_settings.h"

#include <map>
#include <set>
#include <string>
#include <vector>

/// The command line of the fields of registry::RunSettings. Every command that plans renders takes some of
/// them.
namespace orbs::cli {

/// What the command line says of them; the configuration sets those that are not given.
struct RunOptions {
  registry::RunSettings given;
  std::set<std::string> keys;                             // of the settings that the command takes
  std::map<std::string, std::vector<std::string>> lists;  // of those that may be given several times, by key
  std::string size;
  // Options that are no settings of a run.
  std::string output;  // of a command whose folder is not that of a run
  std::string resume;
  std::string shard;
  std::string plan;
  std::string accept_failures;
};

/// The settings that choose targets of a suite.
inline const std::set<std::string> kTargetSettings{"suite", "case", "scene"};

/// The keys of all settings but these.
std::set<std::string> settings_but(const std::set<std::string>& left_out);

/// Adds the options of the settings with these keys. `options` must live as long as the command.
void add_settings(const command_line::Command& command,
                  RunOptions& options,
                  const std::set<std::string>& keys);

/// Adds the options that say what is rendered and how, which `orbs submit` has, too.
void add_choice_options(const command_line::Command& command, RunOptions& options);

/// Adds all options of orbs run.
void add_run_options(const command_line::Command& command, RunOptions& options);

/// `settings` with the options that were given in place of its own.
registry::RunSettings run_settings(const command_line::Command& command,
                                   const RunOptions& options,
                                   registry::RunSettings settings);

/// run_settings of a command that starts renderers itself. InputError when they ask for a sandbox that this
/// machine cannot make.
registry::RunSettings study_settings(const command_line::Command& command,
                                     const RunOptions& options,
                                     const registry::RunSettings& defaults);

}  // namespace orbs::cli
