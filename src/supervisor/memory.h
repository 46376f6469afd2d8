#pragma once

#include "supervisor/descendants.h"
#include "supervisor/memory_files.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace orbs::supervisor {

/// Memory of all processes of a job together.
struct Memory {
  std::size_t resident_bytes = 0;
  std::size_t unbacked_bytes = 0;  // bytes that no file on a disk backs, also those in swap
};

/// What a job holds, watched at a small cost. The sum over processes of what each has resident is cheap, but
/// counts a page once for each process that shares it and what is mapped of a file in memory twice. So it is
/// an upper bound; only when it exceeds what is asked are pages counted by shares (proc(5), smaps_rollup:
/// Pss), for which the kernel visits every page (4 ms per GB).
///
/// Not seen: System V segments that no process has attached, and huge pages that an administrator reserved.
struct MemoryWatch {
  MemoryFiles files = begin_memory_files();
  std::size_t peak_bytes = 0;  // resident, the largest seen
  Memory shares;               // the last count by shares
  Memory bound_at_count;       // the upper bound at that time
  double next_count_at = 0;    // seconds of the steady clock
};

/// Updates the watch. True when the job holds more than `limit` bytes that no file on a disk backs; an empty
/// limit is no limit.
bool exceeds_memory(MemoryWatch& watch,
                    const std::vector<Descendant>& processes,
                    std::optional<std::size_t> limit);

}  // namespace orbs::supervisor
