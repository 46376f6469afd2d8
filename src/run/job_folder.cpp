#include "run/job_folder.h"

#include "base/error.h"
#include "base/files.h"

#include <cctype>
#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

namespace orbs::run {

namespace fs = std::filesystem;

namespace {

bool is_ours(const std::string& name) {
  return name == "job.json" || name == "log.txt" || name == "result.png" || name.starts_with("error-");
}

std::vector<fs::path> in_the_way(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder))
    if (is_ours(entry.path().filename().string()) && entry.symlink_status().type() != fs::file_type::regular)
      found.push_back(entry.path());
  return found;
}

// A file that a renderer leaves may let whoever starts it act as the renderer's user, who may be root: by its
// bits set-user-ID and set-group-ID, or by capabilities (xattr(7), security.capability). A file of ours never
// does. The file is opened, so that no link in its place is followed.
void take_rights(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  struct stat status {};
  if (descriptor < 0) {
    // Its owner may not read it either; the name is of a file, and no process of the renderer is left.
    if (::lstat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode))
      ::chmod(file.c_str(), status.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO));
    return;
  }
  if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) {
    if ((status.st_mode & (S_ISUID | S_ISGID)) != 0)
      ::fchmod(descriptor, status.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO));
    ::fremovexattr(descriptor, "security.capability");
  }
  ::close(descriptor);
}

void take_rights_below(const fs::path& folder) {
  std::error_code failed;
  for (fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, failed),
       end;
       !failed && entry != end; entry.increment(failed)) {
    std::error_code ignored;
    if (entry->symlink_status(ignored).type() == fs::file_type::regular) take_rights(entry->path());
  }
}

std::error_code last_error() { return {errno, std::generic_category()}; }

// Renders that start together make the folders that they share at the same time: what is there is looked at
// only after mkdir(2) has found it, and unlink(2) leaves what another render has made a folder meanwhile.
std::error_code make_one(const fs::path& folder, bool& is_replaced) {
  if (::mkdir(folder.c_str(), S_IRWXU | S_IRWXG | S_IRWXO) == 0) return {};
  if (errno != EEXIST) return last_error();
  std::error_code failed;
  const auto type = fs::symlink_status(folder, failed).type();
  if (type == fs::file_type::directory) return {};
  if (type == fs::file_type::none) return failed;
  if (::unlink(folder.c_str()) == 0) is_replaced = true;
  return ::mkdir(folder.c_str(), S_IRWXU | S_IRWXG | S_IRWXO) == 0 ? std::error_code() : last_error();
}

std::error_code make_each(const fs::path& within, const fs::path& folder, bool& is_replaced) {
  std::error_code failed;
  fs::create_directories(within, failed);
  auto part = within;
  for (const auto& name : folder.lexically_relative(within)) {
    if (failed) return failed;
    part /= name;
    failed = make_one(part, is_replaced);
  }
  return failed;
}

}  // namespace

void make_way(const fs::path& path) {
  if (const auto failed = remove_tree(path))
    throw InputError(fmt::format("{}: cannot be removed, and must make way for the results of its render: {}",
                                 path.string(), failed.message()));
}

bool make_own_folder(const fs::path& within, const fs::path& folder) {
  // What another renderer of this run does to the folders above can undo a part; none goes on for ever.
  constexpr int kTries = 16;
  bool is_replaced = false;
  std::error_code failed;
  for (int i = 0; i < kTries; ++i) {
    failed = make_each(within, folder, is_replaced);
    if (failed != std::errc::no_such_file_or_directory && failed != std::errc::not_a_directory &&
        failed != std::errc::file_exists)
      break;
  }
  if (failed)
    throw WriteError(fmt::format("{}: the folder cannot be made: {}", folder.string(), failed.message()));
  return is_replaced;
}

bool make_room(const fs::path& within, const fs::path& folder) {
  const bool is_replaced = make_own_folder(within, folder);
  try {
    fs::permissions(folder, fs::perms::owner_all, fs::perm_options::add);
    for (const auto& path : in_the_way(folder)) make_way(path);
    take_rights_below(folder);
  } catch (const fs::filesystem_error& e) {
    throw WriteError(fmt::format("{}: cannot be made ready for the results of its render: {}",
                                 folder.string(), e.code().message()));
  }
  return is_replaced;
}

std::string named_within(const std::filesystem::path& folder, std::string text) {
  const auto prefix = folder.string();
  if (prefix.empty()) return text;
  for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at)) {
    const auto end = at + prefix.size();
    const char next = end < text.size() ? text[end] : ' ';
    const bool is_other_folder = std::isalnum(static_cast<unsigned char>(next)) != 0 ||
                                 std::string("._-").find(next) != std::string::npos;
    if (next == '/') {
      text.erase(at, prefix.size() + 1);
    } else if (is_other_folder) {
      at = end;
    } else {
      text.replace(at, prefix.size(), 1, '.');
      ++at;
    }
  }
  return text;
}

}  // namespace orbs::run
