#pragma once

#include <string>

namespace orbs::supervisor {

/// The whole text of a file of /proc; "" when it cannot be read, as that of a process that is gone.
std::string read_proc_file(const std::string& file);

}  // namespace orbs::supervisor
