#pragma once

#include <atomic>
#include <cstddef>

#include <sys/types.h>

namespace orbs::adapters {

/// From now on SIGINT, SIGTERM and SIGHUP only set the flag that is returned, and the program winds up by
/// itself; a second one kills the process groups at risk and ends us at once.
const std::atomic<bool>& catch_interrupts();

/// While it lives, a second interrupt kills the process group of this id, too.
class GroupAtRisk {
 public:
  explicit GroupAtRisk(pid_t group);
  ~GroupAtRisk();
  GroupAtRisk(const GroupAtRisk&) = delete;
  GroupAtRisk& operator=(const GroupAtRisk&) = delete;

 private:
  std::size_t slot_ = 0;
};

}  // namespace orbs::adapters
