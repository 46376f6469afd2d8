#pragma once

#include <functional>

#include <sched.h>

namespace orbs {

/// Binds this process, and all processes it starts from now on, to as many of the cores that it may use, so
/// that no program can take more than others get. It may use all of them again when the binding ends. As many
/// cores as there are, or more, bind nothing.
class CoreBinding {
 public:
  explicit CoreBinding(int cores);
  ~CoreBinding();
  CoreBinding(const CoreBinding&) = delete;
  CoreBinding& operator=(const CoreBinding&) = delete;

 private:
  cpu_set_t before_{};
  bool is_bound_ = false;
};

/// Calls work(index) once for each index in [0, count) on `threads` threads (0: all cores). Any thread may
/// take any index, so results must depend on the index alone. After an exception the remaining indices are
/// left out, all threads stop, and the first exception is rethrown in the caller.
void for_each_index(int count, int threads, const std::function<void(int)>& work);

}  // namespace orbs
