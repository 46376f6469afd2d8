#include "base/files.h"

#include "base/error.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace orbs {

std::string read_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(fmt::format("{}: is a folder, expected a file", path.string()));
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad())
    throw InputError(fmt::format("{}: reading stopped: {}", path.string(), std::strerror(errno)));
  return bytes;
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  static std::atomic<int> counter{0};
  auto beside = path;
  beside += fmt::format(".{}-{}.part", ::getpid(), counter++);
  {
    std::ofstream file(beside, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.flush();
    if (!file) {
      const std::string reason = std::strerror(errno);
      std::error_code ignored;
      std::filesystem::remove(beside, ignored);
      throw WriteError(fmt::format("{}: cannot be written: {}", path.string(), reason));
    }
  }
  std::error_code failed;
  std::filesystem::rename(beside, path, failed);
  if (!failed) return;
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  throw WriteError(fmt::format("{}: cannot be put into place: {}", path.string(), failed.message()));
}

namespace {

// To the disk itself. EINVAL: a file system without that.
void flush_to_disk(const std::filesystem::path& path, int flags) {
  const int descriptor = ::open(path.c_str(), flags | O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  const bool flushed = descriptor >= 0 && (::fsync(descriptor) == 0 || errno == EINVAL);
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!flushed)
    throw WriteError(fmt::format("{}: cannot be written to disk: {}", path.string(), std::strerror(error)));
}

}  // namespace

void put_in_place(const std::filesystem::path& finished, const std::filesystem::path& target) {
  namespace fs = std::filesystem;
  try {
    for (const auto& entry : fs::directory_iterator(finished))
      if (entry.symlink_status().type() == fs::file_type::regular) flush_to_disk(entry.path(), 0);
    flush_to_disk(finished, O_DIRECTORY);
    fs::create_directories(target.parent_path());
    auto old = finished;
    old += ".old";
    // No two folders can change places everywhere; in between there is none, which means "not done yet".
    if (fs::exists(fs::symlink_status(target))) fs::rename(target, old);
    fs::rename(finished, target);
    flush_to_disk(target.parent_path(), O_DIRECTORY);
    fs::remove_all(old);
  } catch (const fs::filesystem_error& e) {
    throw WriteError(fmt::format("{}: cannot be put into place: {}", target.string(), e.code().message()));
  }
}

std::uint64_t content_hash(std::string_view bytes, std::uint64_t seed) {
  std::uint64_t hash = seed;
  for (const char c : bytes) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

std::filesystem::path resolve_path(const std::filesystem::path& base_folder, const std::string& relative) {
  const std::filesystem::path path(relative);
  return std::filesystem::absolute(path.is_absolute() ? path : base_folder / path).lexically_normal();
}

}  // namespace orbs
