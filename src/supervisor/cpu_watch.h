#pragma once

#include "supervisor/descendants.h"

#include <map>
#include <utility>
#include <vector>

#include <sys/types.h>

namespace orbs::supervisor {

/// CPU time of each process of a job as it was last seen. The kernel adds the time of a process to that of
/// the one that waits for it, and nobody has to: where SIGCHLD is ignored, it is lost (wait(2)). So the sum
/// over all that were ever seen is a lower bound beside the kernel's own sum.
struct CpuWatch {
  std::map<std::pair<pid_t, long long>, double> own_seconds;  // by id and start

  void note(const std::vector<Descendant>& processes) {
    for (const auto& process : processes)
      own_seconds[{process.pid, process.started_ticks}] = process.own_cpu_seconds;
  }
  double seconds() const {
    double sum = 0;
    for (const auto& [process, own] : own_seconds) sum += own;
    return sum;
  }
};

}  // namespace orbs::supervisor
