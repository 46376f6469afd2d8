#include "base/cores.h"

namespace orbs {

CoreBinding::CoreBinding(int cores) {
  if (::sched_getaffinity(0, sizeof before_, &before_) != 0) return;
  if (cores < 1 || cores >= CPU_COUNT(&before_)) return;
  cpu_set_t few;
  CPU_ZERO(&few);
  for (int core = 0; core < CPU_SETSIZE && CPU_COUNT(&few) < cores; ++core)
    if (CPU_ISSET(core, &before_)) CPU_SET(core, &few);
  is_bound_ = ::sched_setaffinity(0, sizeof few, &few) == 0;
}

CoreBinding::~CoreBinding() {
  if (is_bound_) ::sched_setaffinity(0, sizeof before_, &before_);
}

}  // namespace orbs
