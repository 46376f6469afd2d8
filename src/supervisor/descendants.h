#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

/// The descendants of a process, from /proc. When the process is a "child subreaper" (prctl(2)), descendants
/// that lose their parent become its children, in any session or group: none escapes by forking.

namespace orbs::supervisor {

/// The whole text of a file of /proc; "" when it cannot be read, as that of a process that is gone.
std::string read_proc_file(const std::string& file);

struct Descendant {
  pid_t pid = 0;
  pid_t parent = 0;
  bool is_zombie = false;  // no thread of it runs any more; its main thread may end long before the others
  double cpu_seconds = 0;  // its own, and those of the children that it has reaped
  double own_cpu_seconds = 0;
  long long started_ticks = 0;  // since the machine was booted: an id may be given again
};

/// All processes below `ancestor`, zombies too.
std::vector<Descendant> descendants_of(pid_t ancestor);

}  // namespace orbs::supervisor
