#include "adapters/export.h"
#include "adapters/process/programs.h"
#include "base/terminal.h"
#include "cli/options.h"
#include "cli/program.h"
#include "registry/new_renderer.h"
#include "registry/placeholders.h"
#include "run/plan/choose_renderers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

namespace {

int add(const registry::Configuration& configuration,
        const registry::NewRenderer& added,
        const Program& program) {
  const auto entry = registry::add_renderer(configuration, added);
  const auto found = run::installed_executable(entry, configuration.root, program.folder);
  print_clean("added to {}\n", configuration.own_file.string());
  print_clean("  name        {}\n", entry.name);
  print_clean("  executable  {}\n", found ? found->string()
                                          : adapters::program_problem(run::program_name(
                                                entry, configuration.root, program.folder)));
  print_clean("  reads       {}\n", entry.format.name);
  print_clean("  declares    {}\n", registry::format_features(entry.support.declares));
  print_clean("  command     {}\n", fmt::join(entry.command.words, " "));
  print_clean(
      "next, in that file:\n"
      "  \"command\"   as its command line is; it may use {{{}}}\n"
      "  \"declares\"  what it can do; what it cannot goes to \"known_limits\", with the reason\n"
      "then: orbs doctor; orbs run -r {}\n",
      fmt::join(registry::command_placeholders(), "}, {"), entry.name);
  return 0;
}

}  // namespace

void add_renderer_command(const command_line::Command& command, const Program& program, Action& action) {
  command.needs_command();
  const auto adding =
      command.add_command("add", "Write a checked entry for a renderer, to be completed by hand");
  const auto configuration = add_configuration_option(adding);
  const auto formats = adapters::scene_formats();
  const auto added = std::make_shared<registry::NewRenderer>();
  adding.add_option("name", added->name, "Its name in lists, tables and folders").required();
  adding.add_option("--executable", added->executable,
                    "Path, or name of a program on PATH (default: the name)");
  adding.add_option("--format", added->scene_format, "Scene format that it reads")
      .one_of({formats.begin(), formats.end()})
      .shows_default();
  adding.add_option("--native-scenes", added->native_scenes,
                    "Ending of scenes written by hand for it, such as xml");
  adding.add_option("--declares", added->declares, "ORB.S levels that it supports").shows_default();
  adding.add_option(
      "command", added->command,
      "Program and arguments, after -- (default: those of a renderer with the same format, or "
      "'{executable} {scene} --output {output} --spp {spp} --seed {seed} --threads {threads}')");
  adding.callback([=, &program, &action] {
    action = [=, &program] { return add(read_configuration(*configuration, program), *added, program); };
  });
}

}  // namespace orbs::cli
