#include "adapters/process/programs.h"
#include "base/error.h"
#include "base/terminal.h"
#include "base/text.h"
#include "cli/program.h"
#include "cli/show_runs.h"
#include "registry/filters.h"
#include "results/run_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

namespace fs = std::filesystem;

struct OpenOptions {
  std::string scene;
  std::string run;        // "": the newest one here that has the scene
  std::string renderers;  // "": all
  std::string viewer = "tev";
  bool only_prints = false;
};

// The reference first, so that a viewer shows the results in front of it; each file once.
std::vector<fs::path> images_in(const fs::path& folder, const OpenOptions& options) {
  const auto run = results::read_run_folder(folder).run;
  std::vector<fs::path> references;
  std::vector<fs::path> images;
  const auto add = [&](const std::string& file, std::vector<fs::path>& files) {
    const auto path = fs::absolute(folder / file).lexically_normal();
    std::error_code ignored;
    if (!file.empty() && fs::exists(path, ignored) &&
        std::find(files.begin(), files.end(), path) == files.end())
      files.push_back(path);
  };
  for (const auto& target : run.targets) {
    if (target.target != options.scene) continue;
    if (!options.renderers.empty() &&
        !registry::matches_any(registry::patterns_of(options.renderers), target.renderer))
      continue;
    add(target.reference_image, references);
    add(target.image, images);
  }
  if (images.empty()) return {};
  references.insert(references.end(), images.begin(), images.end());
  return references;
}

std::vector<fs::path> images_of(const OpenOptions& options) {
  const auto runs = options.run.empty() ? newest_runs() : std::vector<fs::path>{options.run};
  for (const auto& folder : runs)
    if (auto images = images_in(folder, options); !images.empty()) return images;
  throw InputError(fmt::format(
      "{} holds no image of '{}'{}; 'orbs run -s {}' makes one",
      options.run.empty() ? fmt::format("no run in {}", fs::current_path().string()) : options.run,
      options.scene, options.renderers.empty() ? "" : fmt::format(" by '{}'", options.renderers),
      options.scene));
}

// In the place of this process, so that the viewer has the terminal and its exit status is ours.
int start(const fs::path& program, const std::vector<fs::path>& images) {
  std::vector<std::string> words{program.string()};
  for (const auto& image : images) words.push_back(image.string());
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  ::execv(argv[0], argv.data());
  throw InputError(fmt::format("'{}' cannot be started: {}", program.string(), std::strerror(errno)));
}

int open(const OpenOptions& options) {
  const auto images = images_of(options);
  const auto program = adapters::find_program(options.viewer);
  if (program && !options.only_prints) return start(*program, images);
  for (const auto& image : images) print_clean("{}\n", image.string());
  if (!options.only_prints)
    print_clean(
        stderr,
        "orbs: there is no program '{}' here, so the files are only named; --viewer PROGRAM opens them, tev "
        "is at https://github.com/Tom94/tev\n",
        options.viewer);
  return 0;
}

}  // namespace

void add_open_command(const command_line::Command& command, const Program& /*program*/, Action& action) {
  const auto options = std::make_shared<OpenOptions>();
  command.add_option("scene", options->scene, "Scene or difference").required().not_empty("a scene");
  command
      .add_option("run", options->run,
                  "Folder of a run (default: the newest outputs-* here that has an image of the scene)")
      .not_empty("a folder");
  command.add_option("-r,--renderer", options->renderers, "Only these renderers")
      .value_name("NAMES")
      .not_empty("a name");
  command.add_option("--viewer", options->viewer, "Program that shows them")
      .shows_default()
      .not_empty("a program");
  command.add_flag("--print", options->only_prints, "Print the paths, and open nothing");
  command.footer(
      "Opens the reference of a scene and what renderers made of it, as OpenEXR. Without the viewer their paths are "
      "printed.");
  command.callback([=, &action] { action = [=] { return open(*options); }; });
}

}  // namespace orbs::cli
