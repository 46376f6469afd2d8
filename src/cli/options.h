#pragma once

#include "cli/program.h"
#include "command_line/command.h"
#include "registry/configuration.h"
#include "run/plan/plan_file.h"
#include "studies/context.h"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

/// Options that several commands have.

namespace orbs::cli {

/// Adds --configuration FILE; returns the text that it fills.
std::shared_ptr<std::string> add_configuration_option(const command_line::Command& command);

/// Reads the configuration of configuration_place. InputError if there is none.
registry::Configuration read_configuration(const std::string& named, const Program& program);

/// Gives a plan the root of another configuration than the one that it was made from; "" keeps its own.
/// InputError where there is no such file, or it is broken.
void take_configuration(const std::string& named, const Program& program, run::FiledPlan& plan);

/// InputError when the settings ask for a sandbox that this machine cannot make.
void refuse_without_sandbox(bool sandbox);

/// For commands whose images have one side in pixels, --side: --size is a share of the scenes' size in all
/// commands.
void refuse_size_in_pixels(const command_line::Command& command);

/// The values of a repeatable option as one comma-separated list.
std::string joined_list(const std::vector<std::string>& values);

/// The surroundings of a study: its progress goes to `stream` line by line, and from now on an interrupt only
/// sets the context's flag.
studies::StudyContext study_context(const Program& program, std::FILE* stream);

}  // namespace orbs::cli
