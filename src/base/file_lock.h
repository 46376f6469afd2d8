#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace orbs {

/// A file that is locked for as long as the object lives, and gone with it. The system lets go of the lock
/// however the process ends: the file of one that was killed is in nobody's way.
class FileLock {
 public:
  /// `busy` makes the message of the InputError for a lock that another object holds, here or in the process
  /// whose id it is given. InputError, too, when the file cannot be made.
  FileLock(const std::filesystem::path& file, const std::function<std::string(const std::string&)>& busy);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

/// True while somebody holds the lock of `file`; asking is in nobody's way.
bool is_locked(const std::filesystem::path& file);

}  // namespace orbs
