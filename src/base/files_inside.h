#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace orbs {

/// An open regular file. Renaming or replacing it afterwards changes nothing, because the descriptor stays.
class OpenFile {
 public:
  explicit OpenFile(int descriptor, std::uint64_t size) : descriptor_(descriptor), size_(size) {}
  ~OpenFile();
  OpenFile(OpenFile&& other) noexcept;
  OpenFile& operator=(OpenFile&&) = delete;
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  std::uint64_t size() const { return size_; }
  /// file_state of this very file.
  std::string state() const;
  /// Reads up to `count` bytes from `offset`: fewer only at the end of the file or if reading fails.
  std::string read(std::uint64_t offset, std::size_t count) const;

 private:
  int descriptor_;
  std::uint64_t size_;
};

/// A folder that is kept open: its path leads to the same folder as long as the object lives, even if the
/// folder is renamed or a symbolic link takes its name.
class OpenFolder {
 public:
  /// InputError if there is no such folder.
  explicit OpenFolder(const std::filesystem::path& folder);
  ~OpenFolder();
  OpenFolder(const OpenFolder&) = delete;
  OpenFolder& operator=(const OpenFolder&) = delete;

  /// Of Linux: /proc/self/fd/N. Valid in this process only.
  std::filesystem::path path() const;

 private:
  int descriptor_;
};

/// Whether folder/path lies in the folder by its words: it is relative and has no "..". Symbolic links are
/// not looked at.
bool leads_inside(const std::filesystem::path& path);

/// Whether `path` is the folder or lies in it, by the words of both, which must be normal (lexically_normal).
/// Symbolic links are not looked at.
bool lies_in(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Opens folder/relative. Each part of `relative` is opened within the one before, and none may be a symlink,
/// so nothing outside the folder can be reached, even if folders are renamed meanwhile. std::nullopt if there
/// is no such regular file.
std::optional<OpenFile> open_inside(const std::filesystem::path& folder, std::string_view relative);

}  // namespace orbs
