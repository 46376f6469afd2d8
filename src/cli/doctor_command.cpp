#include "cli/commands.h"
#include "runner/renderer_version.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

namespace {

void examine(const registry::Renderer& renderer, const runner::Plan& places) {
  fmt::print("{}\n", renderer.name);
  const auto executable = runner::installed_executable(renderer, places.root, places.build);
  if (executable) {
    fmt::print("  program   {}\n", executable->string());
    if (!renderer.version_command.empty())
      fmt::print("  version   {}\n", runner::renderer_version({renderer, *executable}, places));
  } else {
    fmt::print("  program   not installed: there is no program '{}' here\n",
               runner::program_name(renderer, places.root, places.build));
  }
  fmt::print("  reads     {}{}\n", registry::scene_format_name(renderer.scene_format),
             renderer.native_scenes.empty()
                 ? ""
                 : fmt::format(", hand-written scenes *.{}", renderer.native_scenes));
  fmt::print("  declares  {}\n", registry::format_features(renderer.declares));
  for (const auto& limit : renderer.known_limits)
    fmt::print("  without   {}: {}\n", fmt::join(limit.requirements, ", "), limit.reason);
}

}  // namespace

void add_doctor_command(CLI::App& app, const Program& program, Action& action) {
  auto* command =
      app.add_subcommand("doctor", "Says which renderers are there, which versions, and what each declares");
  const auto configuration = add_configuration_option(*command);
  command->callback([=, &program, &action] {
    action = [=, &program] {
      const auto read = read_configuration(*configuration, program);
      fmt::print("configuration  {}\n", read.file.string());
      runner::Plan places;
      places.root = read.root;
      places.build = program.folder;
      for (const auto& renderer : read.renderers) examine(renderer, places);
      return 0;
    };
  });
}

}  // namespace orbs::cli
