#pragma once

#include <cstddef>
#include <vector>

#include <sys/types.h>

/// The descendants of a process, from /proc. When the process is a "child subreaper" (prctl(2)), descendants
/// that lose their parent become its children, in whatever session or group: none escapes by forking.
namespace orbs::supervisor {

struct Descendant {
  pid_t pid = 0;
  bool is_zombie = false;
  double cpu_seconds = 0;  // its own, and those of the children that it has reaped
};

/// All processes below `ancestor`, zombies too.
std::vector<Descendant> descendants_of(pid_t ancestor);

struct Memory {
  std::size_t resident_bytes = 0;
  std::size_t unbacked_bytes = 0;  // of these, bytes that no file backs
};

/// Of one process now; zeros when it is gone.
Memory memory_of(pid_t pid);

}  // namespace orbs::supervisor
