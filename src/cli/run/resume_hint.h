#pragma once

#include <string>
#include <vector>

namespace orbs::cli {

/// The command line that goes on with an interrupted study: the given one with the same options, with
/// --resume and the folder in place of an output folder.
std::vector<std::string> resume_command(const std::vector<std::string>& command_line,
                                        const std::string& folder);

/// What is printed below a study: how to see it, or how to go on with it when it was interrupted. `shows` is
/// what the page shows of it: "shows the curves in the browser".
std::string next_line(const std::vector<std::string>& command_line,
                      const std::string& folder,
                      bool is_finished,
                      const std::string& shows);

}  // namespace orbs::cli
