#include "run/machine_time.h"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

namespace orbs::run {

namespace {

double seconds_of_this_process() {
  timespec time{};
  if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

// Kernel documentation, filesystems/proc.rst, 1.8: "cpu" and the ticks of user, nice, system, idle, iowait,
// irq, softirq, steal; then those of guests, which user and nice hold as well. A line "cpu0" of each
// processor follows.
std::optional<MachineTime> machine_time(const std::filesystem::path& root) {
  std::ifstream in(root / "proc/stat");
  std::string line;
  if (!std::getline(in, line) || !line.starts_with("cpu ")) return std::nullopt;
  constexpr int kIdle = 3, kIowait = 4, kColumns = 8;
  const double tick_seconds = 1.0 / static_cast<double>(std::max(1L, sysconf(_SC_CLK_TCK)));
  MachineTime time;
  std::istringstream columns(line.substr(4));
  for (int column = 0; column < kColumns; ++column) {
    double ticks = 0;
    if (!(columns >> ticks)) return std::nullopt;
    time.all_seconds += ticks * tick_seconds;
    if (column != kIdle && column != kIowait) time.busy_seconds += ticks * tick_seconds;
  }
  int processors = 0;
  while (std::getline(in, line) && line.starts_with("cpu")) ++processors;
  time.error_of_seconds = std::max(1, processors) * tick_seconds;
  time.own_seconds = seconds_of_this_process();
  return time;
}

std::optional<double> share_of_others(const MachineTime& before,
                                      const MachineTime& after,
                                      double children_seconds) {
  const double all = after.all_seconds - before.all_seconds;
  if (!(all > 0)) return std::nullopt;
  const double busy = after.busy_seconds - before.busy_seconds;
  const double ours = after.own_seconds - before.own_seconds + children_seconds;
  return std::clamp((busy - ours - after.error_of_seconds) / all, 0.0, 1.0);
}

}  // namespace orbs::run
