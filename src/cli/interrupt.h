#pragma once

#include <atomic>

namespace orbs::cli {

/// From now on SIGINT, SIGTERM and SIGHUP only set the flag that is returned, and the program winds up by
/// itself; a second one ends us at once, and the supervisors of what still runs notice and end it.
const std::atomic<bool>& catch_interrupts();

/// Sets the flag, for a run that has seen enough.
void wind_up();

}  // namespace orbs::cli
