#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace orbs {

/// Reads the whole file as bytes. InputError with the reason if it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// Says why `path` is no file that can be read: it is missing, a folder, a device, or a link that leads
/// nowhere. "" for a file.
std::string no_file_problem(const std::filesystem::path& path);

/// Writes beside the target and renames into place, so that a reader sees the old file or the new one, never
/// a part. WriteError if the disk refuses.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Checks before long work that the file can be written afterwards, and changes nothing. InputError if a
/// folder or a device is in its place or its folder is missing, WriteError if nothing can be written beside
/// it.
void check_output_file(const std::filesystem::path& path);

/// Makes the folder and those above it, unless they exist. WriteError with the reason if it cannot be made.
void make_folder(const std::filesystem::path& folder);

/// Removes a file, a link, or a folder with all that it holds, as renderers leave them: also folders that
/// their owner may not write to, and thousands of folders within each other. Says why something is still
/// there; no error where there was nothing.
std::error_code remove_tree(const std::filesystem::path& path);

/// Renames the folder `finished` to `target`, which must lie on the same file system. A reader sees the old
/// folder, none, or the whole new one, even after a power cut. Makes the folders above. WriteError if the
/// disk refuses.
void put_in_place(const std::filesystem::path& finished, const std::filesystem::path& target);

/// FNV-1a, 64 bits (Fowler, Noll, Vo; draft-eastlake-fnv). It tells two versions of a file apart, but does
/// not protect against somebody who wants them to collide.
std::uint64_t content_hash(std::string_view bytes, std::uint64_t seed = 0xcbf29ce484222325ULL);

/// Writes a content_hash as 16 hexadecimal digits, the form that provenance records and job ids use.
std::string hash_text(std::uint64_t hash);

/// Makes `relative` an absolute path, relative to `base_folder`. An absolute path stays as it is.
std::filesystem::path resolve_path(const std::filesystem::path& base_folder, const std::string& relative);

/// The file `name` of our own build or installation: beside the running program, or above the folders of test
/// programs. Where it is expected, when there is none.
std::filesystem::path beside_program(const std::string& name);

/// Device, inode, size and times of a file as text: another text after each change of its content, even one
/// that keeps the size or sets the time of modification back, since nobody can set the time of change. "" if
/// there is no such file. Symbolic links are followed.
std::string file_state(const std::filesystem::path& file);

/// The same of an open file.
std::string file_state(int descriptor);

/// A new folder for unfinished files in the system's temporary folder. It is deleted with the object.
class ScratchFolder {
 public:
  /// `name` tells users who made it. Throws std::filesystem::filesystem_error if it cannot be made.
  explicit ScratchFolder(const std::string& name);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace orbs
