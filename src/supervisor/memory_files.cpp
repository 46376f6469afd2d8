#include "supervisor/memory_files.h"

#include "base/text.h"
#include "supervisor/descendants.h"
#include "supervisor/memory_mounts.h"

#include <algorithm>
#include <ctime>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace orbs::supervisor {

namespace {

struct FileStatus {
  FileId id;
  std::size_t bytes = 0;
  std::int64_t changed_ns = 0;  // ctime, which no program can set
};

constexpr std::int64_t kSecond_ns = 1'000'000'000;

// The status of a regular file, as far as the kernel knows it without asking a server. Returns nothing for
// anything else.
std::optional<FileStatus> status_of(int folder, const char* name) {
  struct statx status {};
  constexpr unsigned kWanted = STATX_TYPE | STATX_INO | STATX_BLOCKS | STATX_CTIME;
  if (::statx(folder, name, AT_STATX_DONT_SYNC | AT_NO_AUTOMOUNT, kWanted, &status) != 0) return std::nullopt;
  if (!S_ISREG(status.stx_mode)) return std::nullopt;
  constexpr std::size_t kBlock_bytes = 512;  // the unit of stx_blocks on every file system
  return FileStatus{{status.stx_dev_major, status.stx_dev_minor, static_cast<ino_t>(status.stx_ino)},
                    static_cast<std::size_t>(status.stx_blocks) * kBlock_bytes,
                    status.stx_ctime.tv_sec * kSecond_ns + status.stx_ctime.tv_nsec};
}

// Memfds lie in a tmpfs of the kernel's own, which is mounted nowhere.
FileId any_memfd() {
  const int file = ::memfd_create("orbs", MFD_CLOEXEC);
  if (file < 0) return {};
  const auto status = status_of(AT_FDCWD, fmt::format("/proc/self/fd/{}", file).c_str());
  ::close(file);
  return status ? status->id : FileId{};
}

// A task may have its own mounts, in which our mountinfo does not list its tmpfs.
bool is_mounted_tmpfs(unsigned major, unsigned minor, pid_t task) {
  const auto device = fmt::format(" {}:{} ", major, minor);
  for (const auto& mount : split(read_proc_file(fmt::format("/proc/{}/mountinfo", task)), '\n'))
    if (mount.find(device) != std::string::npos) return mount.find(" - tmpfs ") != std::string::npos;
  return false;
}

bool is_in_memory(MemoryFiles& known, const FileId& id, pid_t task) {
  if (id.device_major != 0) return false;  // a disk
  static const auto memfd = any_memfd();
  if (id.device_minor == memfd.device_minor) return true;
  const auto [entry, is_new] = known.is_tmpfs.try_emplace({id.device_major, id.device_minor}, false);
  if (is_new) entry->second = is_mounted_tmpfs(id.device_major, id.device_minor, task);
  return entry->second;
}

std::string link_target(int folder, const char* name) {
  std::string target(4096, '\0');
  const auto count = ::readlinkat(folder, name, target.data(), target.size());
  target.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return target;
}

// Notes the files that the task has open. A task of another user shows none, and one that hides itself.
void note_open_files(MemoryFiles& known, pid_t task, std::set<FileId>& open) {
  DIR* folder = ::opendir(fmt::format("/proc/{}/fd", task).c_str());
  if (folder == nullptr) return;
  const int descriptor = ::dirfd(folder);
  while (const dirent* entry = ::readdir(folder)) {
    const auto status = status_of(descriptor, entry->d_name);
    if (!status || !is_in_memory(known, status->id, task)) continue;
    const auto [found, is_new] = known.files.try_emplace(status->id);
    auto& file = found->second;
    if (is_new) file.path = link_target(descriptor, entry->d_name);
    if (is_new && status->changed_ns < known.begin_ns) file.old_bytes = status->bytes;
    file.bytes = status->bytes;
    open.insert(status->id);
  }
  ::closedir(folder);
}

void note_other_files(MemoryFiles& known, const std::vector<pid_t>& tasks) {
  auto used = own_tmpfs_bytes(tasks);
  for (const auto& [id, file] : known.files)
    if (const auto found = used.find({id.device_major, id.device_minor}); found != used.end())
      found->second -= std::min(found->second, file.bytes);
  known.other_bytes = 0;
  for (const auto& [device, bytes] : used) known.other_bytes += bytes;
}

std::int64_t now_of_time_stamps_ns() {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME_COARSE, &now);
  return now.tv_sec * kSecond_ns + now.tv_nsec;
}

}  // namespace

// The kernel stamps files with a clock that stands still for a tick (4 ms). A file written in the tick of the
// call would bear the stamp of one that the job writes, so the job begins with the next tick.
MemoryFiles begin_memory_files() {
  const auto called_ns = now_of_time_stamps_ns();
  MemoryFiles none;
  // Asleep: waiting awake cost 1.1 of the 4.1 ms of CPU time that the supervisor of a short command takes.
  constexpr timespec kPause{0, 200'000};
  do {
    ::nanosleep(&kPause, nullptr);
    none.begin_ns = now_of_time_stamps_ns();
  } while (none.begin_ns == called_ns);
  return none;
}

void update(MemoryFiles& known, const std::vector<pid_t>& tasks) {
  std::set<FileId> open;
  for (const pid_t task : tasks) note_open_files(known, task, open);
  for (auto& [id, file] : known.files) {
    if (open.contains(id)) continue;
    const auto status = status_of(AT_FDCWD, file.path.c_str());
    file.bytes = status && status->id == id ? status->bytes : 0;
  }
  std::erase_if(known.files,
                [&](const auto& entry) { return entry.second.bytes == 0 && !open.contains(entry.first); });
  note_other_files(known, tasks);
}

std::size_t new_bytes(const MemoryFile& file) { return file.bytes - std::min(file.bytes, file.old_bytes); }

std::size_t total_bytes(const MemoryFiles& known) {
  std::size_t bytes = 0;
  for (const auto& [id, file] : known.files) bytes += new_bytes(file);
  return bytes + known.other_bytes;
}

}  // namespace orbs::supervisor
