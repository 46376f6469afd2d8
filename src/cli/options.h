#pragma once

#include "cli/action.h"
#include "registry/configuration.h"
#include "run/plan/plan_file.h"

#include <memory>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the name is the library's
class App;
}

/// Options that several commands have.
namespace orbs::cli {

/// Adds --configuration FILE; returns the text that it fills.
std::shared_ptr<std::string> add_configuration_option(CLI::App& command);

/// Reads the named file or, if `named` is empty, the nearest configuration.json above the working folder or,
/// failing that, above the program. InputError if there is none.
registry::Configuration read_configuration(const std::string& named, const Program& program);

/// Gives a plan the root of another configuration than the one that it was made from; "" keeps its own.
/// InputError where there is no such file.
void take_configuration(const std::string& configuration, run::FiledPlan& plan);

/// Which targets a study is of.
struct TargetFilters {
  std::string suite;  // "" for that of the configuration
  std::vector<std::string> cases, scenes;
  bool sandbox = false;
};

/// Adds --suite, -c/--case, -s/--scene and --sandbox. `filters` must live as long as the command.
void add_filter_options(CLI::App& command, TargetFilters& filters);

/// Adds --sandbox for a study. `sandbox` must live as long as the command.
void add_sandbox_option(CLI::App& command, bool& sandbox);

/// InputError when the settings ask for a sandbox that this machine cannot make.
void refuse_without_sandbox(bool sandbox);

/// The configuration's defaults with these filters in place of its own. InputError as of
/// refuse_without_sandbox.
registry::RunSettings filtered_settings(const registry::Configuration& configuration,
                                        const TargetFilters& filters);

/// Adds --size, the share of the width and height of all images: a text that registry::size_divisor knows.
/// `size` must live as long as the command.
void add_size_option(CLI::App& command, std::string& size);

/// The values of a repeatable option as one comma-separated list.
std::string joined_list(const std::vector<std::string>& values);

}  // namespace orbs::cli
