#include "run/host.h"

#include "base/text.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <string_view>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/utsname.h>

namespace orbs::run {

namespace {

namespace fs = std::filesystem;

// Files of the kernel have no size, and what cannot be read is what the system does not say.
std::vector<std::string> lines_of(const fs::path& file) {
  std::vector<std::string> lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string first_line(const fs::path& file) {
  const auto lines = lines_of(file);
  return lines.empty() ? "" : std::string(trim(lines.front()));
}

// Behind the separator, of the first line that starts with the key.
std::string value_of(const fs::path& file, std::string_view key, char separator) {
  for (const auto& line : lines_of(file))
    if (line.starts_with(key))
      return std::string(trim(std::string_view(line).substr(line.find(separator) + 1)));
  return "";
}

std::string governors(const fs::path& cpus) {
  std::set<std::string> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(cpus, none))
    if (const auto governor = first_line(entry.path() / "cpufreq/scaling_governor"); !governor.empty())
      found.insert(governor);
  return fmt::format("{}", fmt::join(found, " and "));
}

// "MemTotal:  24684084 kB"
std::size_t memory_bytes(const fs::path& root) {
  const auto text = value_of(root / "proc/meminfo", "MemTotal", ':');
  return static_cast<std::size_t>(to_integer(text.substr(0, text.find(' '))).value_or(0)) * 1024;
}

std::string distribution(const fs::path& root) {
  auto name = value_of(root / "etc/os-release", "PRETTY_NAME", '=');
  std::erase(name, '"');
  return name;
}

// Our group of a controller and all above it, as folders: each of them limits us.
std::vector<fs::path> groups_above(const fs::path& mount, const fs::path& group) {
  std::vector<fs::path> folders;
  for (auto at = group.lexically_normal();; at = at.parent_path()) {
    folders.push_back(mount / at.relative_path());
    if (!at.has_relative_path()) return folders;
  }
}

template <typename T>
void lower(std::optional<T>& limit, T to) {
  limit = std::min(limit.value_or(to), to);
}

// "150000 100000": so many microseconds of processor time in each period of so many. No limit is "max", or -1
// in the older files.
void limit_cpu(std::string_view quota, std::string_view period, results::Host& host) {
  const auto used = to_number(quota);
  const auto of = to_number(period);
  if (used && of && *used > 0 && *of > 0) lower(host.cpu_limit_cores, *used / *of);
}

// No limit is "max", or in the older files a number beyond all memory.
void limit_memory(std::string_view text, results::Host& host) {
  const auto bytes = to_integer(text);
  if (!bytes || *bytes < 0) return;
  const auto limit = static_cast<std::size_t>(*bytes);
  if (host.memory_bytes == 0 || limit < host.memory_bytes) lower(host.memory_limit_bytes, limit);
}

// Kernel documentation, admin-guide/cgroup-v2.rst, and for the controllers that still are of version 1
// scheduler/sched-bwc.rst and admin-guide/cgroup-v1/memory.rst.
void read_container_limits(const fs::path& root, results::Host& host) {
  const auto mount = root / "sys/fs/cgroup";
  for (const auto& line : lines_of(root / "proc/self/cgroup")) {
    // "0::/ours" for version 2, "4:cpu,cpuacct:/ours" for version 1
    const auto first = line.find(':');
    const auto second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const auto controllers = line.substr(first + 1, second - first - 1);
    const auto group = line.substr(second + 1);
    if (controllers.empty())
      for (const auto& folder : groups_above(mount, group)) {
        const auto cpu = split(first_line(folder / "cpu.max"), ' ');
        if (cpu.size() == 2) limit_cpu(cpu[0], cpu[1], host);
        limit_memory(first_line(folder / "memory.max"), host);
      }
    for (const auto& controller : split(controllers, ','))
      for (const auto& folder : groups_above(mount / controller, group)) {
        if (controller == "cpu")
          limit_cpu(first_line(folder / "cpu.cfs_quota_us"), first_line(folder / "cpu.cfs_period_us"), host);
        if (controller == "memory") limit_memory(first_line(folder / "memory.limit_in_bytes"), host);
      }
  }
}

std::string compiler() {
#ifdef __clang__
  const std::string name = "clang " __clang_version__;
#else
  const std::string name = "g++ " __VERSION__;
#endif
#ifdef __OPTIMIZE__
  return std::string(trim(name)) + ", optimised";
#else
  return std::string(trim(name)) + ", not optimised";
#endif
}

}  // namespace

results::Host this_host(const fs::path& root) {
  results::Host host;
  utsname names{};
  if (::uname(&names) == 0) {
    host.name = names.nodename;
    host.system = fmt::format("{} {} {}", names.sysname, names.release, names.machine);
  }
  host.cores = static_cast<int>(std::thread::hardware_concurrency());
  host.cpu = value_of(root / "proc/cpuinfo", "model name", ':');
  host.governor = governors(root / "sys/devices/system/cpu");
  host.memory_bytes = memory_bytes(root);
  host.distribution = distribution(root);
  host.compiler = compiler();
  read_container_limits(root, host);
  return host;
}

double load_average() {
  double load = 0;
  return ::getloadavg(&load, 1) == 1 ? load : 0;
}

}  // namespace orbs::run
