#include "registry/limits.h"

namespace orbs::registry {

namespace {

std::size_t bytes_of(double megabytes) {
  constexpr double kMegabyte = 1 << 20;
  return static_cast<std::size_t>(megabytes * kMegabyte);
}

}  // namespace

void apply(const LimitSettings& stated, ProcessLimits& limits) {
  limits.wall_seconds = stated.wall_seconds.value_or(limits.wall_seconds);
  limits.grace_seconds = stated.grace_seconds.value_or(limits.grace_seconds);
  if (stated.cpu_seconds) limits.cpu_seconds = stated.cpu_seconds;
  if (stated.memory_megabytes) limits.memory_bytes = bytes_of(*stated.memory_megabytes);
  if (stated.output_megabytes) limits.output_bytes = bytes_of(*stated.output_megabytes);
  if (stated.log_megabytes) limits.log_bytes = bytes_of(*stated.log_megabytes);
}

}  // namespace orbs::registry
