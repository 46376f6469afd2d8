#include "run/cluster/carried_files.h"

#include "adapters/job.h"
#include "base/files.h"
#include "base/files_inside.h"
#include "run/program_hash.h"

#include <algorithm>
#include <system_error>
#include <vector>

namespace orbs::run {

namespace {

namespace fs = std::filesystem;

void carry(const fs::path& file, const fs::path& to, CarriedFiles& carried) {
  const auto copy = to / file.filename();
  make_folder(to);
  write_file(copy, read_file(file));
  std::error_code ignored;
  fs::permissions(copy, fs::status(file, ignored).permissions(), ignored);
  carried.emplace(file, copy);
}

std::vector<fs::path> files_beside(const fs::path& file) {
  std::vector<fs::path> beside;
  std::error_code failed;
  for (auto entry = fs::directory_iterator(file.parent_path(), failed);
       !failed && entry != fs::directory_iterator(); entry.increment(failed))
    if (entry->path().extension() == file.extension() && no_file_problem(entry->path()).empty())
      beside.push_back(entry->path());
  return beside;
}

// Such as the shell or Python that the command starts: the other machine has its own.
bool is_program_of_system(const fs::path& file, const fs::path& root) {
  std::error_code failed;
  const auto permissions = fs::status(file, failed).permissions();
  return !failed && (permissions & fs::perms::owner_exec) != fs::perms::none &&
         !lies_in(file.lexically_normal(), root);
}

}  // namespace

CarriedFiles carry_files(const Plan& plan, const ChosenRenderer& renderer, const fs::path& folder) {
  CarriedFiles carried;
  const auto to = folder / "programs" / renderer.entry.name;
  const auto plugins = adapters::plugin_files(renderer.entry, plan.root, plan.build);
  for (const auto& file : program_files(renderer, plan)) {
    const bool is_plugin = std::find(plugins.begin(), plugins.end(), file) != plugins.end();
    if (file == renderer.executable || (!is_plugin && is_program_of_system(file, plan.root))) continue;
    carry(file, to, carried);
    if (is_plugin || !file.has_extension() || !lies_in(file.lexically_normal(), plan.root)) continue;
    for (const auto& other : files_beside(file))
      if (!carried.contains(other)) carry(other, to, carried);
  }
  return carried;
}

std::string with_copies(std::string word, const CarriedFiles& files, const fs::path& from) {
  for (const auto& [file, copy] : files)
    if (word.ends_with(file.string())) {
      word.erase(word.size() - file.string().size());
      return word + copy.lexically_relative(from).string();
    }
  return word;
}

}  // namespace orbs::run
