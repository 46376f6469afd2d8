#include "base/error.h"
#include "base/text.h"
#include "cli/command_table.h"
#include "cli/options.h"
#include "registry/cases.h"
#include "runner/choose_renderers.h"
#include "runner/renderer_version.h"

#include <optional>
#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

namespace {

// The scenes of all suites. None if a suite cannot be read, after printing why.
std::optional<std::set<std::string>> scene_names(const registry::Configuration& configuration) {
  std::set<std::string> names;
  for (const auto& suite : configuration.suites) {
    try {
      for (const auto& one_case : registry::load_cases(suite))
        for (const auto& scene : one_case.scenes) names.insert(scene.name);
    } catch (const InputError& e) {
      fmt::print("suite {} cannot be read: {}\n", suite.name, e.what());
      return std::nullopt;
    }
  }
  return names;
}

void examine(const registry::Renderer& renderer,
             const runner::Plan& places,
             const std::optional<std::set<std::string>>& scenes) {
  fmt::print("{}\n", renderer.name);
  const auto executable = runner::installed_executable(renderer, places.root, places.build);
  if (executable) {
    fmt::print("  program   {}\n", executable->string());
    if (!renderer.version_command.empty())
      fmt::print("  version   {}\n", runner::renderer_version({renderer, *executable}, places));
  } else {
    fmt::print("  program   not installed: '{}' was not found\n",
               runner::program_name(renderer, places.root, places.build));
  }
  fmt::print("  reads     {}{}\n", renderer.scene_format,
             renderer.native_scenes.empty()
                 ? ""
                 : fmt::format(", hand-written scenes *.{}", renderer.native_scenes));
  // The program must have been built with each of them; a run says which one is missing.
  for (const auto& [transport, word] : renderer.transports)
    fmt::print("  needs     {} for {} light paths\n", word, transport);
  fmt::print("  declares  {}\n", registry::format_features(renderer.declares));
  for (const auto& limit : renderer.known_limits)
    fmt::print("  lacks     {}: {}\n", fmt::join(limit.requirements, ", "), limit.reason);
  for (const auto& [name, scale] : renderer.spp_scale_of_scenes)
    if (scenes && !scenes->contains(name))
      fmt::print("  spp_scale_of_scenes  no suite has a scene '{}'{}\n", name, closest(name, *scenes));
}

}  // namespace

void add_doctor_command(CLI::App& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  command.callback([=, &program, &action] {
    action = [=, &program] {
      const auto read = read_configuration(*configuration, program);
      fmt::print("configuration  {}\n", read.file.string());
      runner::Plan places;
      places.root = read.root;
      places.build = program.folder;
      const auto scenes = scene_names(read);
      for (const auto& renderer : read.renderers) examine(renderer, places, scenes);
      return 0;
    };
  });
}

}  // namespace orbs::cli
