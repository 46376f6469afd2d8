#pragma once

#include <cstddef>
#include <optional>

namespace orbs {

/// What all processes of one render may use together. An empty limit is no limit.
struct ProcessLimits {
  double wall_seconds = 600;
  std::optional<double> cpu_seconds;        // user and system
  std::optional<std::size_t> memory_bytes;  // resident and not backed by a file, which the kernel could drop
  std::optional<std::size_t> output_bytes;  // in its folder, and of each single file anywhere
  std::size_t log_bytes = 1 << 20;          // of stdout and stderr; the middle of a longer log is left out
  double grace_seconds = 2;                 // between SIGTERM and SIGKILL
};

}  // namespace orbs
