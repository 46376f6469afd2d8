#pragma once

#include "run/plan/plan.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

/// Whether a renderer is still the program that it was.
namespace orbs::run {

/// The files that make a renderer's images and can change without a change of the configuration: its
/// executable, the program that its command starts, its plug-ins, and every file that the command names by an
/// absolute path
/// ("{root}/adapters/cycles.py", "--python=/opt/a.py"). Libraries are not among them.
std::vector<std::filesystem::path> program_files(const ChosenRenderer& renderer, const Plan& plan);

/// Hashes of the contents of files. A file is read again only when its inode, size or one of its times has
/// changed: a renderer has 100 MB, and is asked after before and after each render. All threads may call.
class FileHashes {
 public:
  /// hash_text of the bytes; for a file that cannot be read (a program may be executable only), of its inode,
  /// size and times; "" when there is none.
  std::string of(const std::filesystem::path& file);

 private:
  struct Entry {
    std::string state;  // inode, size and times
    std::string hash;
  };
  std::mutex mutex_;
  std::map<std::filesystem::path, Entry> known_;
};

/// Hash of all program_files of a renderer.
std::string program_hash(const ChosenRenderer& renderer, const Plan& plan, FileHashes& hashes);

/// The programs of a plan's renderers as they are when a run starts. All threads may ask.
class ProgramWatch {
 public:
  explicit ProgramWatch(const Plan& plan);

  const std::string& hash(std::size_t renderer) const { return at_start_[renderer]; }
  bool has_changed(std::size_t renderer);

 private:
  const Plan& plan_;
  FileHashes hashes_;
  std::vector<std::string> at_start_;  // program_hash by renderer
};

}  // namespace orbs::run
