#pragma once

#include "base/files.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace orbs::structure {

/// Lines of a text file without their line ends.
std::vector<std::string> lines_of(const std::filesystem::path& file);

/// All files below `folder` whose extension is listed, sorted. Hidden folders, builds and outputs are left
/// out; files without an extension are in when "" is listed.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder,
                                               const std::set<std::string>& extensions);

/// "src/base/text.h:12: " for messages, with the path relative to `root` and lines counted from 1.
std::string place(const std::filesystem::path& root, const std::filesystem::path& file, std::size_t line);

/// The complaints one below the other, for a test's message.
std::string joined(const std::vector<std::string>& complaints);

/// A folder for the made-up sources on which a rule is shown to fail.
class TestFolder {
 public:
  explicit TestFolder(const std::string& name) : folder_("orbs-" + name) {}
  const std::filesystem::path& path() const { return folder_.path(); }
  /// Writes `text` to a file below the folder; makes the folders on the way.
  void write(const std::string& file, const std::string& text) const;

 private:
  ScratchFolder folder_;
};

}  // namespace orbs::structure
