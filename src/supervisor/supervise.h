#pragma once

#include "supervisor/report.h"
#include "supervisor/start.h"

namespace orbs::supervisor {

/// How long the supervisor waits for a process that SIGKILL does not end: it hangs in the kernel, for example
/// on a network disk that is gone.
inline constexpr double kGiveUp_seconds = 10;

/// Runs the command to its end. Ends it, with all its descendants, at a limit and when `control` (a
/// descriptor) can be read or is closed at its other end. No process that it started is left when this
/// returns. For a program with one thread: blocks signals, reaps all children, makes the process a child
/// subreaper.
Report supervise(const Command& command, int control);

}  // namespace orbs::supervisor
