#include "run/isolate.h"

#include "adapters/process/private_parts.h"
#include "adapters/process/program_places.h"
#include "adapters/process/programs.h"

#include <system_error>

namespace orbs::run {

namespace {

namespace fs = std::filesystem;

void append(std::vector<fs::path>& to, const std::vector<fs::path>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

// Folders of all programs and of the user, which the entry does not name.
bool is_of_entry(const std::string& variable) {
  for (const char* name : {"PATH=", "HOME=", "TMPDIR="})
    if (variable.starts_with(name)) return false;
  return true;
}

// What lies in the folders that are shown, and what of ours the system may have installed. Folders of the
// system itself, which hold hundreds of thousands of files, are not searched.
void hide_private_parts(const fs::path& root, adapters::Isolation& isolation) {
  auto folders = isolation.readable;
  folders.push_back(root / "data");
  for (const auto& folder : folders) {
    std::error_code failed;
    const auto real = fs::canonical(folder, failed);
    if (failed || !fs::is_directory(real, failed) || adapters::is_of_system(real)) continue;
    const auto& parts = adapters::private_parts(real);
    append(isolation.hidden, parts.folders);
    append(isolation.hidden, parts.files);
  }
}

// Its program, and what its entry names, with the folders around.
adapters::Isolation isolation_of_program(const Plan& plan,
                                         const ChosenRenderer& renderer,
                                         const std::vector<std::string>& argv,
                                         const fs::path& folder) {
  adapters::Isolation isolation;
  isolation.folder = folder;
  isolation.memory_bytes = renderer.entry.limits.memory_bytes;
  const auto program = adapters::find_program(argv.front()).value_or(argv.front());
  isolation.readable = adapters::program_places(renderer.executable);
  append(isolation.readable, adapters::program_places(program));
  auto named = argv;
  for (const auto& variable : adapters::child_environment(renderer.entry.command.environment))
    if (is_of_entry(variable)) named.push_back(variable);
  append(isolation.readable, adapters::named_places(named));
  append(isolation.readable, adapters::readable_places(renderer.entry, plan.root, plan.build));
  isolation.hidden.push_back(plan.suite.references);
  hide_private_parts(plan.root, isolation);
  isolation.inputs = {renderer.executable, program};
  return isolation;
}

}  // namespace

std::vector<fs::path> files_of(const scene::Scene& scene) {
  std::vector<fs::path> files;
  for (const auto& texture : scene.textures) files.push_back(texture.file);
  for (const auto& light : scene.lights)
    if (light.ies) files.push_back(light.ies->file);
  return files;
}

adapters::Isolation isolation_of(const Plan& plan,
                                 const ChosenRenderer& renderer,
                                 const scene::Scene& scene,
                                 const std::vector<adapters::Job>& jobs,
                                 const fs::path& run_folder) {
  auto isolation = isolation_of_program(plan, renderer, jobs.front().argv, jobs.front().folder);
  append(isolation.inputs, files_of(scene));
  isolation.hidden.push_back(run_folder);
  std::error_code failed;
  for (auto entry = fs::directory_iterator(fs::absolute(run_folder).parent_path(), failed);
       !failed && entry != fs::directory_iterator(); entry.increment(failed))
    if (std::error_code ignored; fs::exists(entry->path() / "results.json", ignored))
      isolation.hidden.push_back(entry->path());
  return isolation;
}

adapters::Isolation isolation_of_version(const Plan& plan,
                                         const ChosenRenderer& renderer,
                                         const std::vector<std::string>& argv,
                                         const fs::path& folder) {
  return isolation_of_program(plan, renderer, argv, folder);
}

}  // namespace orbs::run
