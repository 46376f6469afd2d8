#pragma once

#include "run/plan/plan.h"

#include <filesystem>
#include <map>
#include <string>

namespace orbs::run {

/// Files of this machine that the command of a renderer names, and where copies of them lie in a folder that
/// is sent to another machine.
using CarriedFiles = std::map<std::filesystem::path, std::filesystem::path>;

/// Copies into folder/programs/<renderer> what the command names by paths that are the same for all renders:
/// plug-ins and scripts, but not the executable or a program of the system, which are the other machine's. Of
/// a script below the root of the plan all files that lie beside it with the same ending come along, since it
/// may import them.
CarriedFiles carry_files(const Plan& plan,
                         const ChosenRenderer& renderer,
                         const std::filesystem::path& folder);

/// The word of a command in the folder `from` with the copies in place of the files.
std::string with_copies(std::string word, const CarriedFiles& files, const std::filesystem::path& from);

}  // namespace orbs::run
