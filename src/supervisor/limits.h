#pragma once

#include <cstddef>
#include <optional>

namespace orbs::supervisor {

/// What one render may take, all its processes together. Nothing: no such limit.
struct Limits {
  double wall_seconds = 600;
  std::optional<double> cpu_seconds;        // user and system
  std::optional<std::size_t> memory_bytes;  // resident and not backed by a file, which the kernel could drop
  std::optional<std::size_t> output_bytes;  // in its folder, and of each single file anywhere
  std::size_t log_bytes = 1 << 20;          // of stdout and stderr; what is beyond is left out of the middle
  double grace_seconds = 2;                 // between TERM and KILL
};

}  // namespace orbs::supervisor
