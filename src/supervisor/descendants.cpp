#include "supervisor/descendants.h"

#include "base/text.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace orbs::supervisor {

// Streams cost three times as much, and there are many files.
std::string read_proc_file(const std::string& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return {};
  std::string text;
  std::array<char, 16384> buffer{};
  for (;;) {
    const auto count = ::read(descriptor, buffer.data(), buffer.size());
    if (count <= 0) break;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  ::close(descriptor);
  return text;
}

namespace {

// proc(5): the name in parentheses may hold anything, so fields are counted from the last ')'.
std::optional<Descendant> process_of(pid_t pid) {
  const auto text = read_proc_file(fmt::format("/proc/{}/stat", pid));
  const auto close = text.rfind(')');
  if (close == std::string::npos) return std::nullopt;
  const auto fields = split(std::string_view(text).substr(close + 2), ' ');
  constexpr std::size_t kUserTime = 11;     // field 14 of the file, and with it 15, 16, 17
  constexpr std::size_t kThreadCount = 17;  // field 20
  constexpr std::size_t kStarted = 19;      // field 22
  if (fields.size() <= kStarted) return std::nullopt;
  static const auto ticks_per_second = static_cast<double>(::sysconf(_SC_CLK_TCK));
  Descendant process;
  process.pid = pid;
  process.parent = static_cast<pid_t>(to_integer(fields[1]).value_or(0));
  process.thread_count = to_integer(fields[kThreadCount]).value_or(0);
  // The state is that of the main thread. While others run, the kernel counts it among them.
  process.is_zombie = (fields[0] == "Z" || fields[0] == "X") && process.thread_count <= 1;
  const auto seconds = [&](std::size_t field) {
    return to_number(fields[field]).value_or(0) / ticks_per_second;
  };
  process.own_cpu_seconds = seconds(kUserTime) + seconds(kUserTime + 1);
  process.cpu_seconds = process.own_cpu_seconds + seconds(kUserTime + 2) + seconds(kUserTime + 3);
  process.started_ticks = to_integer(fields[kStarted]).value_or(0);
  return process;
}

// The entries of a folder of /proc whose names are numbers: processes, or threads of one.
std::vector<pid_t> numbers_in(const std::string& folder) {
  std::vector<pid_t> numbers;
  std::error_code failed;
  for (auto entry = std::filesystem::directory_iterator(folder, failed);
       !failed && entry != std::filesystem::directory_iterator(); entry.increment(failed)) {
    const auto number = to_integer(entry->path().filename().string());
    if (number) numbers.push_back(static_cast<pid_t>(*number));
  }
  return numbers;
}

std::vector<Descendant> all_processes() {
  std::vector<Descendant> processes;
  for (const pid_t pid : numbers_in("/proc"))
    if (const auto process = process_of(pid)) processes.push_back(*process);
  return processes;
}

std::string children_file(pid_t pid, pid_t task) {
  return fmt::format("/proc/{}/task/{}/children", pid, task);
}

// Kernels are built with these files or without (CONFIG_PROC_CHILDREN).
bool lists_children() {
  static const bool exists = ::access(children_file(::getpid(), ::getpid()).c_str(), R_OK) == 0;
  return exists;
}

// The kernel keeps a child with the thread that has forked it.
std::vector<pid_t> children_of(pid_t pid, long long thread_count) {
  std::vector<pid_t> children;
  const auto tasks = thread_count > 1 ? numbers_in(fmt::format("/proc/{}/task", pid)) : std::vector{pid};
  for (const pid_t task : tasks)
    for (const auto& word : words_of(read_proc_file(children_file(pid, task))))
      if (const auto child = to_integer(word)) children.push_back(static_cast<pid_t>(*child));
  return children;
}

}  // namespace

std::vector<Descendant> descendants_of(pid_t ancestor) {
  std::multimap<pid_t, const Descendant*> by_parent;
  const auto processes = all_processes();
  for (const auto& process : processes) by_parent.emplace(process.parent, &process);
  std::vector<Descendant> found;
  std::set<pid_t> seen{ancestor};  // ids are read one after the other and may be taken anew meanwhile
  for (std::vector<pid_t> ahead{ancestor}; !ahead.empty();) {
    const auto [first, last] = by_parent.equal_range(ahead.back());
    ahead.pop_back();
    for (auto child = first; child != last; ++child) {
      if (!seen.insert(child->second->pid).second) continue;
      found.push_back(*child->second);
      ahead.push_back(child->second->pid);
    }
  }
  return found;
}

// A list of children can omit one while another one ends (proc(5)), and a process whose parent ends moves
// from one list to another, maybe one that was read before. So what was seen at the last look is looked at
// anew. It cannot have become somebody else's: with a subreaper above, a descendant stays one until it ends.
std::vector<Descendant> follow_descendants(Followed& followed) {
  if (!lists_children()) return descendants_of(::getpid());
  std::vector<Descendant> found;
  Followed seen;
  std::vector<pid_t> ahead = children_of(::getpid(), 1);
  const auto visit_all = [&] {
    while (!ahead.empty()) {
      const pid_t pid = ahead.back();
      ahead.pop_back();
      const auto process = seen.contains(pid) ? std::nullopt : process_of(pid);
      if (!process) continue;
      seen.emplace(pid, process->started_ticks);
      found.push_back(*process);
      for (const pid_t child : children_of(pid, process->thread_count)) ahead.push_back(child);
    }
  };
  visit_all();
  for (const auto& [pid, started_ticks] : followed) {
    if (seen.contains(pid)) continue;
    const auto process = process_of(pid);
    if (process && process->started_ticks == started_ticks) ahead.push_back(pid);
  }
  visit_all();
  followed = std::move(seen);
  return found;
}

}  // namespace orbs::supervisor
