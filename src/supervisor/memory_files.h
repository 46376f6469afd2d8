#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

/// Files that lie in memory: of memfd_create(2) and in a tmpfs such as /dev/shm. Their pages belong to no
/// process until they are mapped, so that no count of processes sees them.
namespace orbs::supervisor {

struct FileId {
  unsigned device_major = 0;
  unsigned device_minor = 0;
  ino_t inode = 0;
  auto operator<=>(const FileId&) const = default;
};

struct MemoryFile {
  std::size_t bytes = 0;      // allocated, also in swap; a hole takes none
  std::size_t old_bytes = 0;  // of these, bytes that were there before the job: its input
  std::string path;           // where it was when a process had it open
};

/// The files in memory of a job. A file belongs to it once one of its processes was seen with it open, and as
/// long as a process has it open or it lies under its name. So a file that is written and closed between two
/// updates is not noticed, unless it lies where the
/// job alone has mounted something: nothing says then whose it is.
struct MemoryFiles {
  std::int64_t begin_ns = 0;  // of the job, on the clock of the kernel's time stamps
  std::map<FileId, MemoryFile> files;
  std::map<std::pair<unsigned, unsigned>, bool> is_tmpfs;  // by major and minor number of the device
  std::size_t other_bytes = 0;  // of files in folders of a sandbox that nobody has open
};

/// None yet, for a job that begins when this returns, at most some milliseconds later.
MemoryFiles begin_memory_files();

/// Looks at the open files of these tasks (processes or threads of them). Never asks a server, so that a
/// network disk that is gone does not stop it.
void update(MemoryFiles& known, const std::vector<pid_t>& tasks);

/// What the job added to the file.
std::size_t new_bytes(const MemoryFile& file);

/// What it added to all of them, each counted once.
std::size_t total_bytes(const MemoryFiles& known);

}  // namespace orbs::supervisor
