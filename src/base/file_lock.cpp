#include "base/file_lock.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace orbs {

namespace {

// The file may have been removed by its last holder between our opening and our locking it.
bool is_file(int descriptor, const std::filesystem::path& file) {
  struct stat ours {};
  struct stat there {};
  return ::fstat(descriptor, &ours) == 0 && ::stat(file.c_str(), &there) == 0 && ours.st_ino == there.st_ino;
}

std::string holder_of(int descriptor) {
  std::array<char, 32> text{};
  const auto length = ::pread(descriptor, text.data(), text.size(), 0);
  return std::string(
      trim(std::string_view(text.data(), static_cast<std::size_t>(std::max<ssize_t>(length, 0)))));
}

// Whether no process of this machine has that id.
bool is_gone(const std::string& holder) {
  const auto id = to_integer(holder);
  return id && *id > 0 && ::kill(static_cast<pid_t>(*id), 0) != 0 && errno == ESRCH;
}

[[noreturn]] void refuse(const std::filesystem::path& file, int error) {
  throw InputError(fmt::format("{}: cannot be locked: {}", file.string(), std::strerror(error)));
}

// Of the open file, not of the process, so that one process, too, cannot lock it twice; and unlike that of
// flock(2) it can be asked for without being taken, which would be in the way of who wants it.
struct flock whole_file() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

}  // namespace

// A process that is killed while it starts another one leaves that the open file until it executes its
// program: the lock of a holder that is gone is waited for.
FileLock::FileLock(const std::filesystem::path& file,
                   const std::function<std::string(const std::string&)>& busy)
    : file_(file) {
  constexpr auto kPatience = std::chrono::seconds(2);
  const auto give_up = std::chrono::steady_clock::now() + kPatience;
  for (;;) {
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0) refuse(file_, errno);
    const auto lock = whole_file();
    const int error = ::fcntl(descriptor_, F_OFD_SETLK, &lock) == 0 ? 0 : errno;
    if (error == 0 && is_file(descriptor_, file_)) break;
    const auto holder = holder_of(descriptor_);
    ::close(descriptor_);
    if (error == 0) continue;
    if (error != EAGAIN && error != EACCES) refuse(file_, error);
    if (!is_gone(holder) || std::chrono::steady_clock::now() >= give_up) throw InputError(busy(holder));
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const auto holder = fmt::format("{}\n", ::getpid());
  if (::ftruncate(descriptor_, 0) == 0 && ::write(descriptor_, holder.data(), holder.size()) >= 0) return;
  const int error = errno;
  ::close(descriptor_);
  refuse(file_, error);
}

FileLock::~FileLock() {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
  ::close(descriptor_);
}

bool is_locked(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return false;
  auto lock = whole_file();
  const bool taken = ::fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  ::close(descriptor);
  return taken;
}

}  // namespace orbs
