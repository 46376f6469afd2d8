#include "supervisor/descendants.h"

#include "base/text.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace orbs::supervisor {

namespace {

// The start of a file of /proc. Streams cost three times as much, and there are many files.
std::string read_start(const std::string& file) {
  std::array<char, 4096> buffer{};
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return {};
  const auto count = ::read(descriptor, buffer.data(), buffer.size());
  ::close(descriptor);
  return count > 0 ? std::string(buffer.data(), static_cast<std::size_t>(count)) : std::string();
}

struct Process {
  Descendant descendant;
  pid_t parent = 0;
};

// proc(5): the name in parentheses may hold anything, so fields are counted from the last ')'.
std::optional<Process> process_of(pid_t pid) {
  const auto text = read_start(fmt::format("/proc/{}/stat", pid));
  const auto close = text.rfind(')');
  if (close == std::string::npos) return std::nullopt;
  const auto fields = split(std::string_view(text).substr(close + 2), ' ');
  constexpr std::size_t kUserTime = 11;  // field 14 of the file, and with it 15, 16, 17
  if (fields.size() < kUserTime + 4) return std::nullopt;
  static const auto ticks_per_second = static_cast<double>(::sysconf(_SC_CLK_TCK));
  Process process;
  process.descendant.pid = pid;
  process.descendant.is_zombie = fields[0] == "Z" || fields[0] == "X";
  process.parent = static_cast<pid_t>(to_integer(fields[1]).value_or(0));
  for (std::size_t i = kUserTime; i < kUserTime + 4; ++i)
    process.descendant.cpu_seconds += to_number(fields[i]).value_or(0) / ticks_per_second;
  return process;
}

std::vector<Process> all_processes() {
  std::vector<Process> processes;
  std::error_code failed;
  for (auto entry = std::filesystem::directory_iterator("/proc", failed);
       !failed && entry != std::filesystem::directory_iterator(); entry.increment(failed)) {
    const auto pid = to_integer(entry->path().filename().string());
    if (!pid) continue;
    if (const auto process = process_of(static_cast<pid_t>(*pid))) processes.push_back(*process);
  }
  return processes;
}

}  // namespace

std::vector<Descendant> descendants_of(pid_t ancestor) {
  std::multimap<pid_t, const Process*> by_parent;
  const auto processes = all_processes();
  for (const auto& process : processes) by_parent.emplace(process.parent, &process);
  std::vector<Descendant> found;
  std::set<pid_t> seen{ancestor};  // ids are read one after the other and may be taken anew meanwhile
  for (std::vector<pid_t> ahead{ancestor}; !ahead.empty();) {
    const auto [first, last] = by_parent.equal_range(ahead.back());
    ahead.pop_back();
    for (auto child = first; child != last; ++child) {
      if (!seen.insert(child->second->descendant.pid).second) continue;
      found.push_back(child->second->descendant);
      ahead.push_back(child->second->descendant.pid);
    }
  }
  return found;
}

Memory memory_of(pid_t pid) {
  Memory memory;
  for (const auto& line : split(read_start(fmt::format("/proc/{}/status", pid)), '\n')) {
    const auto bytes = [&] {
      const auto value = line.substr(line.find(':') + 1);
      return static_cast<std::size_t>(to_integer(trim(value.substr(0, value.find("kB")))).value_or(0)) * 1024;
    };
    if (line.starts_with("VmRSS:")) memory.resident_bytes = bytes();
    if (line.starts_with("RssAnon:") || line.starts_with("RssShmem:") || line.starts_with("VmSwap:"))
      memory.unbacked_bytes += bytes();
  }
  return memory;
}

}  // namespace orbs::supervisor
