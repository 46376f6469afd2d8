#pragma once

#include "supervisor/report.h"
#include "supervisor/start.h"

namespace orbs::supervisor {

/// Runs the command to its end and ends it, with all its descendants, where that is due: at a limit, and when
/// `control` (a descriptor) can be read or is closed at its other end. Nothing that it started is left when
/// this returns. For a program with one thread: blocks signals, collects all children, makes the process a
/// child subreaper.
Report guard(const Order& order, int control);

}  // namespace orbs::supervisor
