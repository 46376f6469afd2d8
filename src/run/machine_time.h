#pragma once

#include <filesystem>
#include <optional>

namespace orbs::run {

/// The time of all processors of this machine since it was started, in seconds of one processor.
struct MachineTime {
  double busy_seconds = 0;      // of all processes, interrupts, and of others on a shared host ("steal")
  double all_seconds = 0;       // that, and the time without work
  double own_seconds = 0;       // CPU time of this process alone, without its children
  double error_of_seconds = 0;  // of a difference of two busy_seconds: the kernel counts in ticks
};

/// From proc/stat below `root`; nothing where the system does not say.
std::optional<MachineTime> machine_time(const std::filesystem::path& root = "/");

/// The share, from 0 to 1, of the time of all processors that others took between two measurements:
/// what was busy, less what this process took, less the `children_seconds` of what it started, and less the
/// error of counting. Nothing where no time has passed.
std::optional<double> share_of_others(const MachineTime& before,
                                      const MachineTime& after,
                                      double children_seconds);

}  // namespace orbs::run
