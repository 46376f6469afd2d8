#include "base/files_inside.h"

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace orbs {

OpenFile::~OpenFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

OpenFile::OpenFile(OpenFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_) {}

std::string OpenFile::state() const { return file_state(descriptor_); }

std::string OpenFile::read(std::uint64_t offset, std::size_t count) const {
  std::string bytes(count, '\0');
  std::size_t got = 0;
  while (got < count) {
    const auto part = ::pread(descriptor_, bytes.data() + got, count - got, static_cast<off_t>(offset + got));
    if (part <= 0) break;
    got += static_cast<std::size_t>(part);
  }
  bytes.resize(got);
  return bytes;
}

OpenFolder::OpenFolder(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0)
    throw InputError(
        fmt::format("{}: the folder cannot be opened: {}", folder.string(), std::strerror(errno)));
}

OpenFolder::~OpenFolder() { ::close(descriptor_); }

std::filesystem::path OpenFolder::path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

bool leads_inside(const std::filesystem::path& path) {
  return path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
}

bool lies_in(const std::filesystem::path& path, const std::filesystem::path& folder) {
  const auto differ = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return differ.first == folder.end();
}

std::optional<OpenFile> open_inside(const std::filesystem::path& folder, std::string_view relative) {
  if (relative.empty() || relative.find('\0') != std::string_view::npos) return std::nullopt;
  int at = ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  const auto parts = split(relative, '/');
  for (std::size_t i = 0; i < parts.size() && at >= 0; ++i) {
    const bool is_last = i + 1 == parts.size();
    // O_NONBLOCK: a pipe would keep us waiting for a writer.
    const int flags = is_last ? O_RDONLY | O_NONBLOCK : O_PATH | O_DIRECTORY;
    const bool is_name = !parts[i].empty() && parts[i] != "." && parts[i] != "..";
    const int next = is_name ? ::openat(at, parts[i].c_str(), flags | O_NOFOLLOW | O_CLOEXEC) : -1;
    ::close(at);
    at = next;
  }
  if (at < 0) return std::nullopt;
  struct stat status {};
  if (::fstat(at, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(at);
    return std::nullopt;
  }
  return OpenFile(at, static_cast<std::uint64_t>(status.st_size));
}

}  // namespace orbs
