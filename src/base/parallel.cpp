#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

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

void for_each_index(int count, int threads, const std::function<void(int)>& work) {
  const int wanted = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto drain = [&] {
    try {
      for (int index = next++; index < count; index = next++) work(index);
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> pool;
    for (int i = 1; i < std::min(wanted, count); ++i) pool.emplace_back(drain);
    drain();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace orbs
