#pragma once

#include <cstddef>
#include <vector>

#include <sys/types.h>

/// The processes below one of ours, from /proc. Once it is a "child subreaper" (prctl(2)) whatever loses its
/// parent becomes our child, whatever session or group it made for itself: nothing gets away by forking.
namespace orbs::supervisor {

struct Descendant {
  pid_t pid = 0;
  bool is_zombie = false;
  double cpu_seconds = 0;  // its own, and that of the children that it has waited for
};

/// All processes below `ancestor`, zombies too.
std::vector<Descendant> descendants_of(pid_t ancestor);

struct Memory {
  std::size_t resident_bytes = 0;
  std::size_t unbacked_bytes = 0;  // of these, what no file stands behind
};

/// Of one process now; zeros when it is gone.
Memory memory_of(pid_t pid);

}  // namespace orbs::supervisor
