#include "supervisor/memory_mounts.h"

#include "base/text.h"
#include "supervisor/descendants.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/statfs.h>

namespace orbs::supervisor {

namespace {

// The inode of a namespace of mounts says which it is; 0 of a task that is gone or hides itself.
ino_t namespace_of(const std::string& task) {
  struct stat status {};
  return ::stat(fmt::format("/proc/{}/ns/mnt", task).c_str(), &status) == 0 ? status.st_ino : 0;
}

struct Mount {
  Device device;
  std::string place;
};

// Blanks and backslashes of a place are written as \\040 and so on (proc(5)).
std::string without_escapes(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 3 < text.size()) {
      out += static_cast<char>(std::strtol(std::string(text.substr(i + 1, 3)).c_str(), nullptr, 8));
      i += 3;
    } else {
      out += text[i];
    }
  }
  return out;
}

std::vector<Mount> tmpfs_of(const std::string& task) {
  std::vector<Mount> mounts;
  for (const auto& line : split(read_proc_file(fmt::format("/proc/{}/mountinfo", task)), '\n')) {
    if (line.find(" - tmpfs ") == std::string::npos) continue;
    const auto words = words_of(line);  // id, parent, major:minor, root, place
    const auto numbers = split(words[2], ':');
    const auto major = to_integer(numbers.front());
    const auto minor = to_integer(numbers.back());
    if (major && minor)
      mounts.push_back(
          {{static_cast<unsigned>(*major), static_cast<unsigned>(*minor)}, without_escapes(words[4])});
  }
  return mounts;
}

std::size_t used_bytes(const std::string& place) {
  struct statfs status {};
  if (::statfs(place.c_str(), &status) != 0 || status.f_blocks < status.f_bfree) return 0;
  return (status.f_blocks - status.f_bfree) * static_cast<std::size_t>(status.f_bsize);
}

}  // namespace

std::map<Device, std::size_t> own_tmpfs_bytes(const std::vector<pid_t>& tasks) {
  std::map<Device, std::size_t> bytes;
  std::set<ino_t> seen{0, namespace_of("self")};
  std::set<Device> ours;
  for (const auto task : tasks) {
    const auto name = std::to_string(task);
    if (!seen.insert(namespace_of(name)).second) continue;
    if (ours.empty())
      for (const auto& mount : tmpfs_of("self")) ours.insert(mount.device);
    for (const auto& mount : tmpfs_of(name)) {
      if (ours.contains(mount.device)) continue;
      auto& most = bytes[mount.device];  // a mount over another hides what that holds
      most = std::max(most, used_bytes(fmt::format("/proc/{}/root{}", name, mount.place)));
    }
  }
  return bytes;
}

}  // namespace orbs::supervisor
