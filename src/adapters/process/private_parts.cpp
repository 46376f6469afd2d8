#include "adapters/process/private_parts.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <system_error>

namespace orbs::adapters {

namespace {

namespace fs = std::filesystem;

bool is_one_of(const std::string& word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// All that a version control holds, in each of its versions.
bool is_repository(const fs::path& folder) {
  std::error_code ignored;
  return is_one_of(folder.filename().string(), {".git", ".hg", ".svn", ".jj", ".bzr", "_darcs", "CVS"}) ||
         (fs::exists(folder / "HEAD", ignored) &&
          fs::is_directory(folder / "objects", ignored));  // bare, of git
}

// A run in any state.
bool is_run(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / "results.json", ignored) || fs::exists(folder / "run.json", ignored) ||
         fs::exists(folder / ".unfinished", ignored);
}

std::string start_of(const fs::path& file, std::size_t bytes) {
  std::ifstream in(file, std::ios::binary);
  std::string start(bytes, '\0');
  in.read(start.data(), static_cast<std::streamsize>(bytes));
  start.resize(static_cast<std::size_t>(in.gcount()));
  return start;
}

// Whatever its name.
bool is_image_with_record(const fs::path& file) {
  constexpr std::string_view kMagic{"\x76\x2f\x31\x01", 4};
  constexpr std::size_t kHeader = 16384;  // its attributes stand in the order of their names
  if (start_of(file, kMagic.size()) != kMagic) return false;
  return start_of(file, kHeader).find("orbs.") != std::string::npos;
}

bool is_case(const fs::path& file) {
  constexpr std::size_t kEnough = 256;
  return file.extension() == ".json" && start_of(file, kEnough).find("\"orbs-case/") != std::string::npos;
}

// What is written beside references.
bool is_record(const fs::path& file) {
  return is_one_of(file.extension().string(), {".json", ".md", ".txt"});
}

void search(const fs::path& folder, PrivateParts& parts) {
  if (is_repository(folder) || is_run(folder)) {
    parts.folders.push_back(folder);
    return;
  }
  std::vector<fs::path> images;
  std::vector<fs::path> below;
  bool holds_more = false;
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    std::error_code ignored;
    const auto type = entry->symlink_status(ignored).type();
    if (type == fs::file_type::directory) below.push_back(entry->path());
    if (type != fs::file_type::regular) continue;
    if (is_case(entry->path()))
      parts.files.push_back(entry->path());
    else if (is_image_with_record(entry->path()))
      images.push_back(entry->path());
    else
      holds_more = holds_more || !is_record(entry->path());
  }
  // One folder in the place of hundreds of files.
  if (!images.empty() && below.empty() && !holds_more)
    parts.folders.push_back(folder);
  else
    parts.files.insert(parts.files.end(), images.begin(), images.end());
  std::sort(below.begin(), below.end());
  for (const auto& one : below) search(one, parts);
}

}  // namespace

const PrivateParts& private_parts(const fs::path& folder) {
  static std::mutex mutex;
  static std::map<fs::path, PrivateParts> found;
  const std::scoped_lock lock(mutex);
  const auto [known, is_new] = found.try_emplace(folder);
  if (is_new) search(folder, known->second);
  return known->second;
}

}  // namespace orbs::adapters
