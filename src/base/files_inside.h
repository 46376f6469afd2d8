#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace orbs {

/// A regular file that lies in a folder, opened; what happens to its name afterwards changes nothing.
class OpenFile {
 public:
  explicit OpenFile(int descriptor, std::uint64_t size) : descriptor_(descriptor), size_(size) {}
  ~OpenFile();
  OpenFile(OpenFile&& other) noexcept;
  OpenFile& operator=(OpenFile&&) = delete;
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  std::uint64_t size() const { return size_; }
  /// Up to `count` bytes from `offset`; fewer only at the end of the file or when reading fails.
  std::string read(std::uint64_t offset, std::size_t count) const;

 private:
  int descriptor_;
  std::uint64_t size_;
};

/// Opens folder/relative. Each part of `relative` is opened within the one before, and none may be a symlink:
/// nothing outside the folder can be reached, whatever is renamed meanwhile. Nothing for whatever is no
/// regular file there.
std::optional<OpenFile> open_inside(const std::filesystem::path& folder, std::string_view relative);

}  // namespace orbs
