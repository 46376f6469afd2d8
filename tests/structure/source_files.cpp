#include "structure/source_files.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>

namespace orbs::structure {

namespace fs = std::filesystem;

namespace {

bool is_left_out(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return name.starts_with(".") ? name != ".ci"
                               : name.starts_with("build") || name.starts_with("outputs-") ||
                                     name == "__pycache__" || name == "node_modules";
}

}  // namespace

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<fs::path> files_below(const fs::path& folder, const std::set<std::string>& extensions) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (fs::recursive_directory_iterator at(folder), end; at != end; ++at) {
    if (at->is_directory() && is_left_out(at->path())) {
      at.disable_recursion_pending();
    } else if (at->path().filename() == ".git") {
      continue;  // a file, in a linked working tree
    } else if (at->is_regular_file() && extensions.contains(at->path().extension().string())) {
      files.push_back(at->path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string place(const fs::path& root, const fs::path& file, std::size_t line) {
  return fmt::format("{}:{}: ", fs::relative(file, root).string(), line);
}

std::string joined(const std::vector<std::string>& complaints) {
  std::string text;
  for (const auto& complaint : complaints) text += complaint + "\n";
  return text;
}

void TestFolder::write(const std::string& file, const std::string& text) const {
  fs::create_directories((path() / file).parent_path());
  std::ofstream(path() / file) << text;
}

}  // namespace orbs::structure
