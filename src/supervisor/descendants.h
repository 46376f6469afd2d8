#pragma once

#include <map>
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
  long long thread_count = 1;
};

/// All processes below `ancestor`, zombies too. Reads every process of the machine.
std::vector<Descendant> descendants_of(pid_t ancestor);

/// The descendants of this process that were there at the last look: when each started, by its id.
using Followed = std::map<pid_t, long long>;

/// All processes below this one, which is a child subreaper with a single thread. Reads only these, so it may
/// be called often. What starts while it looks may be missing until the next look; what it has seen once
/// stays until it ends.
std::vector<Descendant> follow_descendants(Followed& followed);

}  // namespace orbs::supervisor
