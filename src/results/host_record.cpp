#include "results/host_record.h"

#include <fmt/format.h>

namespace orbs::results {

std::string timing_machine(const Host& host) {
  if (host.cpu.empty()) return "";
  auto text = fmt::format("{}, {} core{}", host.cpu, host.cores, host.cores == 1 ? "" : "s");
  if (!host.governor.empty()) text += fmt::format(", governor {}", host.governor);
  if (host.cpu_limit_cores) text += fmt::format(", container limited to {:g} cores", *host.cpu_limit_cores);
  if (!host.distribution.empty()) text += fmt::format(", {}", host.distribution);
  return text;
}

}  // namespace orbs::results
