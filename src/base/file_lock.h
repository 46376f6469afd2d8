#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace orbs {

/// A file that is locked while the object lives and deleted with it. The system releases the lock however the
/// process ends, so the file of a process that was killed stops nobody.
class FileLock {
 public:
  /// InputError if another object holds the lock, here or in another process: `busy` gets the process id and
  /// makes the message. InputError, too, if the file cannot be made.
  FileLock(const std::filesystem::path& file, const std::function<std::string(const std::string&)>& busy);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

/// True while somebody holds the lock of `file`. Asking takes no lock.
bool is_locked(const std::filesystem::path& file);

}  // namespace orbs
