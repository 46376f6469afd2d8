#pragma once

#include "supervisor/report.h"
#include "supervisor/start.h"

namespace orbs::supervisor {

/// Runs the command to its end. Ends it, with all its descendants, at a limit and when `control` (a
/// descriptor) can be read or is closed at its other end. No process that it started is left when this
/// returns. For a program with one thread: blocks signals, reaps all children, makes the process a child
/// subreaper.
Report supervise(const Command& command, int control);

}  // namespace orbs::supervisor
