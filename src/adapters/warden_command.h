#pragma once

#include "adapters/process.h"

#include <string>
#include <vector>

namespace orbs::adapters {

/// The command line of the warden that runs `request`. orbs-warden lies beside the running program, or, as
/// for test programs, in a folder above.
std::vector<std::string> warden_command(const ProcessRequest& request);

}  // namespace orbs::adapters
