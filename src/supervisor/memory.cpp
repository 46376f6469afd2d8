#include "supervisor/memory.h"

#include "base/text.h"
#include "supervisor/descendants.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <linux/kcmp.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace orbs::supervisor {

namespace {

// Counting by shares may take this share of one core. It reads the page tables of the renderer, which would
// show in the times that are measured.
constexpr double kCountShare = 0.005;
constexpr double kLongestWait_seconds = 10;

double now_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The bytes of a line "Name:   123 kB".
std::size_t bytes_of(std::string_view line) {
  const auto value = line.substr(line.find(':') + 1);
  return static_cast<std::size_t>(to_integer(trim(value.substr(0, value.find("kB")))).value_or(0)) * 1024;
}

// Counts what the task has mapped, also what it shares. Returns nothing for a task that has ended: its memory
// belongs to the other threads.
std::optional<Memory> resident_memory(pid_t task) {
  Memory memory;
  bool has_memory = false;
  for (const auto& line : split(read_proc_file(fmt::format("/proc/{}/status", task)), '\n')) {
    has_memory = has_memory || line.starts_with("VmRSS:");
    if (line.starts_with("VmRSS:")) memory.resident_bytes = bytes_of(line);
    if (line.starts_with("RssAnon:") || line.starts_with("RssShmem:") || line.starts_with("VmSwap:"))
      memory.unbacked_bytes += bytes_of(line);
  }
  return has_memory ? std::optional(memory) : std::nullopt;
}

struct Task {
  pid_t id = 0;
  Memory resident;
};

// The main thread of the process, or another one when that has ended before it.
std::optional<Task> running_task(pid_t pid) {
  if (const auto memory = resident_memory(pid)) return Task{pid, *memory};
  std::error_code failed;
  for (auto entry = std::filesystem::directory_iterator(fmt::format("/proc/{}/task", pid), failed);
       !failed && entry != std::filesystem::directory_iterator(); entry.increment(failed)) {
    const auto id = static_cast<pid_t>(to_integer(entry->path().filename().string()).value_or(0));
    if (const auto memory = resident_memory(id)) return Task{id, *memory};
  }
  return std::nullopt;
}

// Divides each page by the number of processes that map it. Returns nothing where the kernel refuses or is
// too old to tell the kinds of pages; then the whole counts.
std::optional<Memory> shares_of(pid_t task) {
  Memory memory;
  bool has_kinds = false;
  for (const auto& line : split(read_proc_file(fmt::format("/proc/{}/smaps_rollup", task)), '\n')) {
    has_kinds = has_kinds || line.starts_with("Pss_Anon:");
    if (line.starts_with("Pss:")) memory.resident_bytes = bytes_of(line);
    if (line.starts_with("Pss_Anon:") || line.starts_with("Pss_Shmem:") || line.starts_with("SwapPss:"))
      memory.unbacked_bytes += bytes_of(line);
  }
  return has_kinds ? std::optional(memory) : std::nullopt;
}

// Reads the first line of a mapping in smaps, "start-end rwxp offset major:minor inode path". Returns nothing
// for any other line.
std::optional<FileId> mapped_file(std::string_view line) {
  const auto words = words_of(line.substr(0, line.find('/')));
  if (words.size() < 5 || words[0].find('-') == std::string::npos) return std::nullopt;
  const auto colon = words[3].find(':');
  const auto inode = to_integer(words[4]);
  if (colon == std::string::npos || !inode) return std::nullopt;
  const auto hexadecimal = [](const std::string& text) {
    return static_cast<unsigned>(std::strtoul(text.c_str(), nullptr, 16));
  };
  return FileId{hexadecimal(words[3].substr(0, colon)), hexadecimal(words[3].substr(colon + 1)),
                static_cast<ino_t>(*inode)};
}

// Adds the task's shares of the files of the job.
void add_mapped_shares(const MemoryFiles& known, pid_t task, std::map<FileId, std::size_t>& shares) {
  std::optional<FileId> file;
  for (const auto& line : split(read_proc_file(fmt::format("/proc/{}/smaps", task)), '\n')) {
    if (const auto next = mapped_file(line)) file = known.files.contains(*next) ? next : std::nullopt;
    if (file && line.starts_with("Pss:")) shares[*file] += bytes_of(line);
  }
}

// Orders tasks by their address space, which a child has in common with its parent between vfork(2) and exec:
// its pages are not shared but the same. Where the kernel does not compare, all are taken to differ.
struct ByAddressSpace {
  bool operator()(pid_t a, pid_t b) const {
    const auto order = ::syscall(SYS_kcmp, a, b, KCMP_VM, 0, 0);
    constexpr long kGreater = 2;
    return order < 0 || order > kGreater ? a < b : order == 1;
  }
};

Memory count_by_shares(const std::vector<Task>& tasks, const MemoryFiles& known) {
  Memory sum{known.other_bytes, known.other_bytes};
  std::map<FileId, std::size_t> mapped;
  std::set<pid_t, ByAddressSpace> counted;
  for (const auto& task : tasks) {
    if (!counted.insert(task.id).second) continue;
    const auto memory = shares_of(task.id).value_or(task.resident);
    sum.resident_bytes += memory.resident_bytes;
    sum.unbacked_bytes += memory.unbacked_bytes;
    if (!known.files.empty()) add_mapped_shares(known, task.id, mapped);
  }
  for (const auto& [id, file] : known.files) {
    const auto rest = new_bytes(file) - std::min(new_bytes(file), mapped[id]);
    sum.resident_bytes += rest;
    sum.unbacked_bytes += rest;
  }
  return sum;
}

std::size_t growth(std::size_t before, std::size_t now) { return now - std::min(before, now); }

}  // namespace

bool exceeds_memory(MemoryWatch& watch,
                    const std::vector<Descendant>& processes,
                    std::optional<std::size_t> limit) {
  std::vector<Task> tasks;
  std::vector<pid_t> ids;
  for (const auto& process : processes) {
    const auto task = running_task(process.pid);
    if (!task) continue;
    tasks.push_back(*task);
    ids.push_back(task->id);
  }
  update(watch.files, ids);
  const auto in_files = total_bytes(watch.files);
  Memory bound{in_files, in_files};
  for (const auto& task : tasks) {
    bound.resident_bytes += task.resident.resident_bytes;
    bound.unbacked_bytes += task.resident.unbacked_bytes;
  }
  const auto most = limit.value_or(std::numeric_limits<std::size_t>::max());
  const bool is_exact = tasks.size() <= 1 && in_files == 0;
  if (is_exact) watch.peak_bytes = std::max(watch.peak_bytes, bound.resident_bytes);
  if (is_exact || (bound.unbacked_bytes <= most && bound.resident_bytes <= watch.peak_bytes))
    return bound.unbacked_bytes > most;
  // Between counts the job is taken to hold what it held at the last one, plus the growth of the bound.
  const double begin = now_seconds();
  const auto possible =
      watch.shares.unbacked_bytes + growth(watch.bound_at_count.unbacked_bytes, bound.unbacked_bytes);
  if (begin < watch.next_count_at && possible <= most) return false;
  watch.shares = count_by_shares(tasks, watch.files);
  watch.bound_at_count = bound;
  watch.peak_bytes = std::max(watch.peak_bytes, watch.shares.resident_bytes);
  const double end = now_seconds();
  watch.next_count_at = end + std::min((end - begin) / kCountShare, kLongestWait_seconds);
  return watch.shares.unbacked_bytes > most;
}

}  // namespace orbs::supervisor
