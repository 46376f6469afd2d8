#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace orbs::results {

/// What images were rendered on. Texts are "" and numbers 0 where the system does not say.
struct Host {
  std::string name;
  std::string cpu;       // its model
  int cores = 0;         // that a process may use
  std::string governor;  // of the clock: "performance"
  std::size_t memory_bytes = 0;
  std::string system;        // kernel, its release, architecture
  std::string distribution;  // "Debian GNU/Linux 12 (bookworm)"
  std::string compiler;      // of orbs and its tracer
  // Of the container, which a process does not see otherwise; nothing where there is no limit.
  std::optional<double> cpu_limit;  // in cores
  std::optional<std::size_t> memory_limit_bytes;

  friend bool operator==(const Host&, const Host&) = default;
};

/// What times depend on, as one text: processor, cores, governor, the container's share of them,
/// distribution. Times are of the same kind of machine where the texts are equal and not ""; "" is for an
/// unknown processor. Neither the name of the machine nor its memory nor the kernel's release are in it,
/// which differ between nodes that are as fast as each other; and not the compiler or the versions of
/// programs, as what a change of these costs is a question that times are compared for.
std::string timing_machine(const Host& host);

}  // namespace orbs::results
