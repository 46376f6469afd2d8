#pragma once

#include "adapters/process.h"

#include <string>
#include <vector>

namespace orbs::adapters {

/// The command line of the supervisor that runs `request`. orbs-supervisor lies beside the running program,
/// or, as for test programs, in a folder above.
std::vector<std::string> supervisor_command(const ProcessRequest& request);

}  // namespace orbs::adapters
