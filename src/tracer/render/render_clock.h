#pragma once

#include "tracer/render/rendering.h"

#include <chrono>
#include <ctime>

namespace orbs::tracer {

/// Times a part of a rendering from its construction on: wall clock, and CPU time of all threads.
class RenderClock {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  /// `traversal_seconds` is left to those who traverse.
  RenderTime time() const {
    return {.seconds = seconds(),
            .cpu_seconds = static_cast<double>(std::clock() - cpu_start_) / CLOCKS_PER_SEC};
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::clock_t cpu_start_ = std::clock();
};

}  // namespace orbs::tracer
