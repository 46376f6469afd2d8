#pragma once

#include "cli/program.h"
#include "registry/configuration_files.h"

#include <filesystem>
#include <string>

/// Where the files of the configuration lie.
namespace orbs::cli {

struct ConfigurationPlace {
  registry::ConfigurationFiles files;  // those that are there
  std::filesystem::path own;           // that commands write to; "" where the user has no folder for it
};

/// The shipped file, above the program; that of the system, in /etc/orbs or the folder that
/// ORBS_SYSTEM_FOLDER names; that of the user, in $XDG_CONFIG_HOME/orbs or ~/.config/orbs; and over them
/// `named` or, if it is
/// "", the nearest configuration.json above the working folder. The file that commands write to is `named`,
/// or the nearest, or that of the user, and never that of an installation or of the system. InputError if
/// there is no file at all, or `named` is none.
ConfigurationPlace configuration_place(const std::string& named, const Program& program);

}  // namespace orbs::cli
