#pragma once

#include "json/fields.h"

#include <cstddef>
#include <optional>
#include <string>

#include <fmt/format.h>

namespace orbs::results {

/// The machine that images were rendered on. Texts are "" and numbers 0 where the system does not say.
struct Host {
  std::string name;
  std::string cpu;       // the processor's model
  int cores = 0;         // the cores that a process may use
  std::string governor;  // the clock's governor: "performance"
  std::size_t memory_bytes = 0;
  std::string system;        // kernel, release, architecture
  std::string distribution;  // "Debian GNU/Linux 12 (bookworm)"
  std::string compiler;      // what orbs and its tracer were compiled with
  // Limits of the container, which a process does not see otherwise; none where there is no limit.
  std::optional<double> cpu_limit_cores;
  std::optional<std::size_t> memory_limit_bytes;

  friend bool operator==(const Host&, const Host&) = default;
};

/// A host that nobody noted is left out of a record.
inline bool is_absent(const Host& host) { return host == Host{}; }

template <class Visitor, json::RecordOf<Host> Record>
void fields(Visitor& visit, Record& host) {
  visit("name", host.name);
  visit("cpu", host.cpu);
  visit("cores", host.cores, {.range = {.min = 0}});
  visit("governor", host.governor);
  visit("memory_bytes", host.memory_bytes);
  visit("system", host.system);
  visit("distribution", host.distribution);
  visit("compiler", host.compiler);
  visit("cpu_limit_cores", host.cpu_limit_cores);
  visit("memory_limit_bytes", host.memory_limit_bytes);
}

/// The facts that times depend on, as one text: processor, cores, governor, the container's share of them,
/// distribution. Two times can be compared if their texts are equal and not ""; "" stands for an unknown
/// processor. The name of the machine, its memory and the kernel's release are left out because they differ
/// between nodes of equal speed; the compiler and the versions of programs are left out because the cost of
/// changing them is a question that times are compared for.
inline std::string timing_machine(const Host& host) {
  if (host.cpu.empty()) return "";
  auto text = fmt::format("{}, {} core{}", host.cpu, host.cores, host.cores == 1 ? "" : "s");
  if (!host.governor.empty()) text += fmt::format(", governor {}", host.governor);
  if (host.cpu_limit_cores) text += fmt::format(", container limited to {:g} cores", *host.cpu_limit_cores);
  if (!host.distribution.empty()) text += fmt::format(", {}", host.distribution);
  return text;
}

}  // namespace orbs::results
