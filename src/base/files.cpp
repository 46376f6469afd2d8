#include "base/files.h"

#include "base/error.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
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

std::string no_file_problem(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const auto named = fs::symlink_status(path, ignored).type();
  const auto meant = fs::status(path, ignored).type();
  if (meant == fs::file_type::regular) return "";
  if (named == fs::file_type::not_found || named == fs::file_type::none)
    return fmt::format("there is no file {}", path.string());
  const bool leads_nowhere = meant == fs::file_type::not_found || meant == fs::file_type::none;
  return fmt::format("{} is {}, expected a file", path.string(),
                     meant == fs::file_type::directory ? "a folder"
                     : leads_nowhere                   ? "a symbolic link that leads nowhere"
                                                       : "a device or a pipe");
}

namespace {

// The file in which what is to become `path` is written first.
std::filesystem::path write_beside(const std::filesystem::path& path, std::string_view bytes) {
  static std::atomic<int> counter{0};
  auto beside = path;
  beside += fmt::format(".{}-{}.part", ::getpid(), counter++);
  std::ofstream file(beside, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.flush();
  if (file) return beside;
  const std::string reason = std::strerror(errno);
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  throw WriteError(fmt::format("{}: cannot be written: {}", path.string(), reason));
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  const auto beside = write_beside(path, bytes);
  std::error_code failed;
  std::filesystem::rename(beside, path, failed);
  if (!failed) return;
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  throw WriteError(fmt::format("{}: cannot be put into place: {}", path.string(), failed.message()));
}

void check_output_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (const auto problem = no_file_problem(path);
      !problem.empty() && std::filesystem::exists(std::filesystem::symlink_status(path, ignored)))
    throw InputError(problem);
  if (const auto folder = path.parent_path();
      !folder.empty() && !std::filesystem::is_directory(folder, ignored))
    throw InputError(fmt::format("{}: there is no folder {}; make it, or name another file", path.string(),
                                 folder.string()));
  std::filesystem::remove(write_beside(path, ""), ignored);
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    throw WriteError(fmt::format("{}: the folder cannot be made: {}", folder.string(), failed.message()));
}

namespace {

std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder, bool only_folders) {
  namespace fs = std::filesystem;
  std::vector<fs::path> entries;
  std::error_code failed;
  for (auto entry = fs::directory_iterator(folder, failed); !failed && entry != fs::directory_iterator();
       entry.increment(failed))
    if (std::error_code ignored;
        !only_folders || entry->symlink_status(ignored).type() == fs::file_type::directory)
      entries.push_back(entry->path());
  return entries;
}

void allow_writing(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::permissions(folder, std::filesystem::perms::owner_all, std::filesystem::perm_options::add,
                               ignored);
}

// One round of remove_tree: of each folder in `top`, removes the files and moves the folders up to `top`,
// where the next round finds them. False when no folder could be removed.
bool remove_top_folders(const std::filesystem::path& top, int round) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  int moved = 0;
  bool removed = false;
  for (const auto& folder : entries_of(top, true)) {
    allow_writing(folder);
    for (const auto& inner : entries_of(folder, true)) {
      allow_writing(inner);
      fs::rename(inner, top / fmt::format(".moved-{}-{}", round, moved++), ignored);
    }
    for (const auto& file : entries_of(folder, false)) fs::remove(file, ignored);
    removed = fs::remove(folder, ignored) || removed;
  }
  return removed;
}

}  // namespace

std::error_code remove_tree(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code failed;
  fs::remove_all(path, failed);
  std::error_code ignored;
  if (!failed || fs::symlink_status(path, ignored).type() != fs::file_type::directory) return failed;
  allow_writing(path);
  // The library holds a descriptor for each level, and a process may have some thousand.
  for (int round = 0; remove_top_folders(path, round); ++round) {
  }
  fs::remove_all(path, failed);
  return failed;
}

namespace {

// All that was written to the disk of that folder. One call instead of one fsync for each of a dozen files:
// each would wait for a separate commit, ten times as long in all.
void flush_disk_of(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const bool flushed = descriptor >= 0 && ::syncfs(descriptor) == 0;
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!flushed)
    throw WriteError(fmt::format("{}: cannot be written to disk: {}", folder.string(), std::strerror(error)));
}

}  // namespace

void put_in_place(const std::filesystem::path& finished, const std::filesystem::path& target) {
  namespace fs = std::filesystem;
  try {
    flush_disk_of(finished);  // before the name says that it is whole
    fs::create_directories(target.parent_path());
    auto old = finished;
    old += ".old";
    // No two folders can change places everywhere; in between there is none, which means "not done yet".
    if (fs::exists(fs::symlink_status(target))) fs::rename(target, old);
    fs::rename(finished, target);
    remove_tree(old);  // beside the unfinished renders, which are removed when the run ends
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

std::filesystem::path beside_program(const std::string& name) {
  std::error_code failed;
  const auto folder = std::filesystem::read_symlink("/proc/self/exe", failed).parent_path();
  for (const auto& place : {folder, folder.parent_path(), folder.parent_path().parent_path()})
    if (std::filesystem::exists(place / name, failed)) return place / name;
  return folder / name;
}

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

ScratchFolder::ScratchFolder(const std::string& name) {
  auto pattern = (std::filesystem::temp_directory_path() / (name + "-XXXXXX")).string();
  if (::mkdtemp(pattern.data()) == nullptr)
    throw std::filesystem::filesystem_error("cannot make a scratch folder", pattern,
                                            std::error_code(errno, std::generic_category()));
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() { remove_tree(path_); }

}  // namespace orbs
