#include "results/work_folder.h"

#include "base/files.h"

#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

namespace orbs::results {

namespace fs = std::filesystem;

namespace {

constexpr const char* kUnfinished = ".unfinished";

}  // namespace

// The process id keeps it apart from renders of a killed run that are just being ended by their supervisors.
WorkFolder::WorkFolder(const fs::path& run) : path_(run / kUnfinished / fmt::format("{}", ::getpid())) {
  remove_tree(run / kUnfinished);
  make_folder(path_);
}

WorkFolder::~WorkFolder() { remove_tree(path_.parent_path()); }

bool is_unfinished(const fs::path& run, const fs::path& folder) {
  std::error_code failed;
  for (auto entry = fs::directory_iterator(run / kUnfinished, failed);
       !failed && entry != fs::directory_iterator(); entry.increment(failed))
    if (std::error_code ignored; fs::is_directory(entry->path() / folder, ignored)) return true;
  return false;
}

}  // namespace orbs::results
