#pragma once

#include "adapters/process/supervised_child.h"

#include <string>

namespace orbs::process_tests {

/// What a program does is scripted in a shell here; the harness itself starts programs without one.
adapters::ProcessRequest shell(const std::string& script);

/// Whether the process with this id, in decimal, runs. A killed orphan stays in the table of processes until
/// somebody collects it, and the kill takes a moment to arrive: waits for that.
bool is_running(const std::string& id);

}  // namespace orbs::process_tests
