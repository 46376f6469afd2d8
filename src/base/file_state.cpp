#include "base/file_state.h"

#include <fmt/format.h>
#include <sys/stat.h>

namespace orbs {

namespace {

std::string text_of(const struct stat& status) {
  return fmt::format("{} {} {} {}.{:09} {}.{:09}", status.st_dev, status.st_ino, status.st_size,
                     status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_ctim.tv_sec,
                     status.st_ctim.tv_nsec);
}

}  // namespace

std::string file_state(const std::filesystem::path& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 ? text_of(status) : "";
}

std::string file_state(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 ? text_of(status) : "";
}

}  // namespace orbs
