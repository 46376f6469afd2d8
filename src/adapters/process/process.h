#pragma once

#include "adapters/process/supervised_child.h"
#include "supervisor/report.h"

#include <string>

/// Programs as child processes: started without a shell, supervised, measured and ended together with all
/// their descendants, each by one orbs-supervisor.
namespace orbs::adapters {

struct ProcessResult : supervisor::Report {
  std::string output;    // stdout and stderr, capped as the log is
  std::string orphaned;  // how its supervisor ended without a report; "" when it left one
};

/// Runs one program to its end. Never throws for a failure of the program; WriteError when the log cannot be
/// written, after the program has been ended.
ProcessResult run_process(const ProcessRequest& request);

/// "SIGSEGV" for 11, "signal 99" for one without a name.
std::string signal_name(int signal);

}  // namespace orbs::adapters
