#pragma once

#include "cli/action.h"
#include "command_line/command.h"
#include "registry/configuration.h"

#include <memory>
#include <string>
#include <vector>

/// Options that several commands have.
namespace orbs::cli {

/// Adds --configuration FILE; returns the text that it fills.
std::shared_ptr<std::string> add_configuration_option(const command_line::Command& command);

/// Reads the named file or, if `named` is empty, the nearest configuration.json above the working folder or,
/// failing that, above the program. InputError if there is none.
registry::Configuration read_configuration(const std::string& named, const Program& program);

/// Which targets a study is of.
struct TargetFilters {
  std::string suite;  // "" for that of the configuration
  std::vector<std::string> cases, scenes;
};

/// Adds --suite, -c/--case and -s/--scene. `filters` must live as long as the command.
void add_filter_options(const command_line::Command& command, TargetFilters& filters);

/// The configuration's defaults with these filters in place of its own.
registry::RunSettings filtered_settings(const registry::Configuration& configuration,
                                        const TargetFilters& filters);

/// Adds --size, the share of the width and height of all images: a text that registry::size_divisor knows.
/// `size` must live as long as the command.
void add_size_option(const command_line::Command& command, std::string& size);

/// The values of a repeatable option as one comma-separated list.
std::string joined_list(const std::vector<std::string>& values);

}  // namespace orbs::cli
