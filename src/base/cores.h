#pragma once

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

}  // namespace orbs
