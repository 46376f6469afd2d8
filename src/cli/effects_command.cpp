#include "base/error.h"
#include "base/terminal.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run/run_options.h"
#include "registry/cases.h"
#include "report/effects_table.h"
#include "results/record.h"
#include "run/plan/scenes.h"
#include "scene/load/load_scene.h"

#include <filesystem>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

using results::SceneRecord;

SceneRecord record_of(const std::string& name,
                      const std::filesystem::path& file,
                      const std::vector<std::filesystem::path>& data_folders,
                      const std::string& camera) {
  const auto scene = with_note(fmt::format("reading scene '{}'", name),
                               [&] { return scene::load_scene(file, data_folders, camera); });
  for (const auto& warning : scene.notes.warnings) print_clean(stderr, "orbs: warning: {}\n", warning);
  return run::scene_record(name, scene);
}

struct Options {
  std::vector<std::string> scenes;
  RunOptions run;
  bool as_json = false;
};

// A word that ends in .json is a file, others are names in the suite.
std::vector<SceneRecord> records(const Options& options,
                                 const registry::Configuration& configuration,
                                 const std::string& suite_name) {
  std::vector<SceneRecord> found;
  std::vector<std::string> names;
  for (const auto& word : options.scenes)
    if (word.ends_with(".json"))
      found.push_back(record_of(word, word, {}, ""));
    else
      names.push_back(word);
  if (options.scenes.empty()) names.emplace_back("*");
  if (names.empty()) return found;
  const auto& suite = registry::find_suite(configuration, suite_name);
  for (const auto& scene : registry::scenes_of(suite, joined_list(names)))
    found.push_back(record_of(scene.name, scene.file, suite.data, scene.camera));
  return found;
}

}  // namespace

void add_effects_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<Options>();
  command.add_option(
      "scenes", options->scenes,
      "Scenes of the suite, by name or pattern, or scene files (default: all scenes of the suite)");
  add_settings(command, options->run, {"suite"});
  command.add_flag("--json", options->as_json, "Print everything as JSON, for programs");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      const auto read = read_configuration(*configuration, program);
      const auto found = records(*options, read, run_settings(command, options->run, read.defaults).suite);
      if (options->as_json) {
        print_raw(stdout, results::scenes_json(found));
      } else {
        print_clean("{}", report::effects_text(found));
      }
      return 0;
    };
  });
}

}  // namespace orbs::cli
